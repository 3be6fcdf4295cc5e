// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/tin_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geo/ellipsoid.h"

namespace qmesh {

namespace {

struct Corner {
  double u, v, height;
};

constexpr double kDegree = wgs84::kPi / 180;

/// Metres a unit of u and v at a place of the tile.
struct UnitMetres {
  double east, north;
};

UnitMetres unitMetres(const GeoBox& box, double v) {
  const double latitude = box.south + (box.north - box.south) * v / kQuantizedMax;
  const double unit = wgs84::kSemiMajor * kDegree / kQuantizedMax;
  return {std::max(1e-9, (box.east - box.west) * unit * std::cos(latitude * kDegree)),
          (box.north - box.south) * unit};
}

/// The sharpest angle, degrees.
double sharpestAngle(const std::array<Corner, 3>& t, const UnitMetres& unit) {
  double sharpest = 180;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto side = [&](const Corner& to) {
      return Vec3{(to.u - t[k].u) * unit.east, (to.v - t[k].v) * unit.north,
                  to.height - t[k].height};
    };
    const Vec3 a = side(t[(k + 1) % 3]), b = side(t[(k + 2) % 3]);
    const double x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x;
    const double dot = a.x * b.x + a.y * b.y + a.z * b.z;
    sharpest = std::min(sharpest, std::atan2(std::sqrt(x * x + y * y + z * z), dot) / kDegree);
  }
  return sharpest;
}

/// Takes the nodes of triangle after triangle, each node once.
class Measurer {
 public:
  Measurer(const HeightTile& tile, const TileFrame& frame)
      : tile_(tile), frame_(frame), box_(tile.lattice().scheme().box(tile.id())),
        taken_(std::size_t(frame.cells() + 1) * std::size_t(frame.cells() + 1)) {}

  void add(const std::array<Corner, 3>& t) {
    const UnitMetres unit = unitMetres(box_, (t[0].v + t[1].v + t[2].v) / 3);
    const double angle = sharpestAngle(t, unit);
    quality.minAngle = std::min(quality.minAngle, angle);
    quality.sumAngles += angle;
    ++quality.triangles;
    addNodes(t, unit);
  }

  TinQuality quality;

 private:
  void addNodes(const std::array<Corner, 3>& t, const UnitMetres& unit) {
    const Corner &a = t[0], &b = t[1], &c = t[2];
    const double area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    const double alongU =
        ((b.height - a.height) * (c.v - a.v) - (c.height - a.height) * (b.v - a.v)) / area;
    const double alongV =
        ((c.height - a.height) * (b.u - a.u) - (b.height - a.height) * (c.u - a.u)) / area;
    const double flatness =
        1 / std::sqrt(1 + std::pow(alongU / unit.east, 2) + std::pow(alongV / unit.north, 2));
    const auto [west, east] = std::minmax({a.u, b.u, c.u});
    const auto [south, north] = std::minmax({a.v, b.v, c.v});
    for (int j = firstRow(south); j <= frame_.cells() && frame_.nodeV(j) <= north; ++j) {
      for (int i = firstColumn(west); i <= frame_.cells() && frame_.nodeU(i) <= east; ++i) {
        const double u = frame_.nodeU(i) - a.u, v = frame_.nodeV(j) - a.v;
        const double toB = u * (c.v - a.v) - v * (c.u - a.u);
        const double toC = v * (b.u - a.u) - u * (b.v - a.v);
        const double slack = 1e-12 * kQuantizedMax * kQuantizedMax;
        if (toB < -slack || toC < -slack || toB + toC > area + slack || isTaken(i, j))
          continue;
        const double error = std::abs(a.height + alongU * u + alongV * v - tile_.at(i, j));
        quality.height.add(error);
        quality.distance.add(error * flatness);
        ++quality.nodes;
      }
    }
  }

  int firstRow(double v) const {
    int j = frame_.nearestRow(std::uint16_t(v));
    return frame_.nodeV(j) < v ? j + 1 : j;
  }
  int firstColumn(double u) const {
    int i = frame_.nearestColumn(std::uint16_t(u));
    return frame_.nodeU(i) < u ? i + 1 : i;
  }

  bool isTaken(int i, int j) {
    const std::size_t node = std::size_t(j) * std::size_t(frame_.cells() + 1) + std::size_t(i);
    const bool before = taken_[node];
    taken_[node] = true;
    return before;
  }

  const HeightTile& tile_;
  const TileFrame& frame_;
  GeoBox box_;
  std::vector<bool> taken_;
};

} // namespace

void ErrorSums::add(double error) {
  max = std::max(max, error);
  sum += error;
  sumSquared += error * error;
}

void ErrorSums::add(const ErrorSums& other) {
  max = std::max(max, other.max);
  sum += other.sum;
  sumSquared += other.sumSquared;
}

void TinQuality::add(const TinQuality& other) {
  nodes += other.nodes;
  height.add(other.height);
  distance.add(other.distance);
  minAngle = std::min(minAngle, other.minAngle);
  sumAngles += other.sumAngles;
  triangles += other.triangles;
}

double TinQuality::rms(const ErrorSums& errors) const {
  return nodes ? std::sqrt(errors.sumSquared / double(nodes)) : 0;
}

TinQuality measureQuality(const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
  Measurer measurer(tile, frame);
  const auto corner = [&](std::uint32_t k) {
    const TinVertex& vertex = tin.vertices[k];
    return Corner{double(vertex.u), double(vertex.v), frame.decode(vertex.q)};
  };
  for (const TinTriangle& t : tin.triangles)
    measurer.add({corner(t[0]), corner(t[1]), corner(t[2])});
  return measurer.quality;
}

} // namespace qmesh
