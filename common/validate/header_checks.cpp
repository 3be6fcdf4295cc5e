// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "codec/format.h"
#include "geo/bounding.h"
#include "geo/ellipsoid.h"
#include "geo/octahedral.h"
#include "surface/surface_raster.h"
#include "validate/mesh_checks.h"

namespace qmesh {

namespace {

/// Metres that sphere and horizon point may be off: float64 arithmetic of other programs.
constexpr double kSlack = 0.01;
/// A sphere this much larger than ours is called too large.
constexpr double kLooseSphere = 1.5;
/// Heights beyond these are not on Earth, metres.
constexpr double kLowest = -12000, kHighest = 9000;

std::string metres(double value) {
  return formatNumber(std::round(value * 1000) / 1000) + " m";
}

bool finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

class HeaderCheck {
 public:
  HeaderCheck(const TileMesh& mesh, const std::vector<Vec3>& points, const TileContext& context,
              Findings& findings)
      : mesh_(mesh), header_(mesh.header), points_(points), context_(context), findings_(findings) {
  }

  void run() {
    checkHeights();
    const bool sphere = finite(header_.sphere.centre) && std::isfinite(header_.sphere.radius);
    if (!sphere)
      add(401, "the bounding sphere");
    else
      checkSphere();
    if (!finite(header_.centre))
      add(401, "the centre");
    else if (sphere &&
             length(header_.centre - header_.sphere.centre) > header_.sphere.radius + kSlack)
      add(409,
          metres(length(header_.centre - header_.sphere.centre)) + " from the sphere's centre");
    if (!finite(header_.horizon))
      add(401, "the horizon point");
    else
      checkHorizon();
    if (!mesh_.extensions.normals.empty())
      checkNormals();
  }

 private:
  void add(int code, const std::string& what) { findings_.push_back({code, context_.place, what}); }
  void checkHeights();
  void checkSphere();
  void checkHorizon();
  void checkNormals();

  const TileMesh& mesh_;
  const TileHeader& header_;
  const std::vector<Vec3>& points_;
  const TileContext& context_;
  Findings& findings_;
};

void HeaderCheck::checkHeights() {
  if (header_.minHeight > header_.maxHeight) {
    add(406, metres(double(header_.minHeight)) + " and " + metres(double(header_.maxHeight)));
    return;
  }
  const auto [low, high] = std::minmax_element(mesh_.q.begin(), mesh_.q.end());
  const double lowest = decodedHeight(header_, *low), highest = decodedHeight(header_, *high);
  if (lowest < kLowest || highest > kHighest)
    add(408, metres(lowest) + " to " + metres(highest));
  const double coarse = std::max(0.01, context_.geometricError / 1000); // metres
  const double range = double(header_.maxHeight) - double(header_.minHeight);
  if (range / format::kQuantizedMax > coarse && 2 * (highest - lowest) + coarse < range * 0.98)
    add(407, metres(range) + " for heights of " + metres(lowest) + " to " + metres(highest));
}

void HeaderCheck::checkSphere() {
  double reach = 0;
  for (const Vec3& point : points_)
    reach = std::max(reach, length(point - header_.sphere.centre));
  const double beyond = reach - header_.sphere.radius;
  if (beyond > kSlack) {
    add(402, "by " + metres(beyond));
    return;
  }
  const double enough = boundingSphere(points_).radius;
  if (header_.sphere.radius > kLooseSphere * enough + 1)
    add(403, metres(header_.sphere.radius) + " where " + metres(enough) + " would do");
}

void HeaderCheck::checkHorizon() {
  constexpr double kNever = 100; // radii: nobody loses such a point
  const double given = length(header_.horizon);
  if (!(given > 0)) {
    add(404, "it is the middle of the Earth");
    return;
  }
  const Vec3& h = header_.horizon;
  const Vec3 unit = h * (1 / std::max({std::abs(h.x), std::abs(h.y), std::abs(h.z)}));
  const Vec3 direction = {unit.x * wgs84::kSemiMajor, unit.y * wgs84::kSemiMajor,
                          unit.z * wgs84::kSemiMinor};
  const double needed = std::min(kNever, length(horizonOcclusionPoint(direction, points_)));
  const double low = (needed - given) * wgs84::kSemiMajor;
  const bool used = header_.minHeight >= 0; // CesiumJS passes over it elsewhere
  if (low > 1)
    add(used ? 404 : 405, "it is at " + formatNumber(given) + " radii, " + formatNumber(needed) +
                              (used ? " is needed" : " is needed (not used: heights below 0)"));
  else if (needed < kNever && given > 1 + 1.5 * (needed - 1) + 1e-3)
    add(405, "it is at " + formatNumber(given) + " radii, " + formatNumber(needed) + " would do");
}

void HeaderCheck::checkNormals() {
  constexpr double kBelow = -0.05; // 8 bits and steep cliffs
  std::size_t below = 0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Vec3 normal =
        octDecode({mesh_.extensions.normals[2 * k], mesh_.extensions.normals[2 * k + 1]});
    below += dot(normal, points_[k]) < kBelow * length(points_[k]);
  }
  if (below > 0)
    add(308, std::to_string(below) + " of " + std::to_string(points_.size()) + " normals");
}

} // namespace

std::vector<Vec3> earthFixed(const TileMesh& mesh, const GeoBox& box) {
  std::vector<Vec3> points(mesh.vertexCount());
  const double width = (box.east - box.west) / format::kQuantizedMax;
  const double height = (box.north - box.south) / format::kQuantizedMax;
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = wgs84::toEcef(box.west + mesh.u[k] * width, box.south + mesh.v[k] * height,
                              decodedHeight(mesh.header, mesh.q[k]));
  return points;
}

void checkHeader(const TileMesh& mesh, const std::vector<Vec3>& points, const TileContext& context,
                 Findings& findings) {
  HeaderCheck(mesh, points, context, findings).run();
}

} // namespace qmesh
