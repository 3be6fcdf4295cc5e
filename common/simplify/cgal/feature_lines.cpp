// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/feature_lines.h"

#include <cmath>

#include "geo/ellipsoid.h"
#include "simplify/full_grid.h"

namespace qmesh {

namespace {

/// The eight ways from a node, counter-clockwise from east; the opposite of d is d + 4.
constexpr int kDirections = 8;
constexpr int kColumnStep[kDirections] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int kRowStep[kDirections] = {0, 1, 1, 1, 0, -1, -1, -1};

int opposite(int direction) {
  return (direction + kDirections / 2) % kDirections;
}

int directionOf(int di, int dj) {
  int direction = 0;
  while (kColumnStep[direction] != di || kRowStep[direction] != dj)
    ++direction;
  return direction;
}

int countBits(std::uint8_t bits) {
  int count = 0;
  for (int d = 0; d < kDirections; ++d)
    count += bits >> d & 1;
  return count;
}

int firstBit(std::uint8_t bits) {
  int d = 0;
  while ((bits >> d & 1) == 0)
    ++d;
  return d;
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Of length 1, or 0 for a triangle without area (at a pole): that one is sharp to no other.
Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const double size = length(normal);
  return size > 0 ? normal * (1 / size) : Vec3{};
}

/// True where two normals differ by more than the angle with that cosine.
bool isSharp(const Vec3& a, const Vec3& b, double cosine) {
  const bool bothAreas = dot(a, a) > 0 && dot(b, b) > 0;
  return bothAreas && dot(a, b) < cosine;
}

} // namespace

const std::vector<NodeLine>& FeatureTracer::trace(const HeightTile& tile,
                                                  const MetricNodes& positions,
                                                  const FeatureRules& rules,
                                                  const std::vector<std::uint8_t>& mayEnd) {
  tile_ = &tile;
  grid_ = NodeGrid(tile.cells());
  findSharpEdges(positions, rules.angleDegrees);
  dropForbidden(mayEnd);
  unwalked_ = sharp_;
  lines_.clear();
  const auto count = NodeIndex(grid_.size());
  for (NodeIndex node = 0; node < count; ++node) {
    if (countBits(sharp_[std::size_t(node)]) == 2)
      continue;
    while (unwalked_[std::size_t(node)] != 0)
      walk(node, firstBit(unwalked_[std::size_t(node)]), rules.minimumEdges);
  }
  for (NodeIndex node = 0; node < count; ++node) { // closed lines are left
    if (unwalked_[std::size_t(node)] != 0)
      walk(node, firstBit(unwalked_[std::size_t(node)]), rules.minimumEdges);
  }
  return lines_;
}

void FeatureTracer::findSharpEdges(const MetricNodes& positions, double angleDegrees) {
  const int n = grid_.cells();
  const double cosine = std::cos(angleDegrees * wgs84::kRadiansPerDegree);
  sharp_.assign(grid_.size(), 0);
  normals_.assign(std::size_t(2 * n), {});
  readRow(positions, 0, north_);
  for (int j = 0; j < n; ++j) {
    south_.swap(north_);
    readRow(positions, j + 1, north_);
    below_.swap(normals_);
    normals_.resize(std::size_t(2 * n));
    makeNormals(j);
    compareRow(j, cosine);
  }
}

void FeatureTracer::readRow(const MetricNodes& positions, int j, std::vector<Vec3>& row) const {
  row.clear();
  for (int i = 0; i <= grid_.cells(); ++i)
    row.push_back(positions.at(i, j));
}

/// Of each cell the triangle with its south side, then the one with its north side.
void FeatureTracer::makeNormals(int j) {
  for (int i = 0; i < grid_.cells(); ++i) {
    const auto west = std::size_t(i), east = west + 1;
    const Vec3 &sw = south_[west], &se = south_[east], &nw = north_[west], &ne = north_[east];
    const bool rising = cutsRising(*tile_, i, j);
    normals_[2 * west] = unitNormal(sw, se, rising ? ne : nw);
    normals_[2 * west + 1] = unitNormal(rising ? sw : se, ne, nw);
  }
}

/// The edges within row j of cells and those on its south side.
void FeatureTracer::compareRow(int j, double cosine) {
  bool risingWest = false;
  for (int i = 0; i < grid_.cells(); ++i) {
    const auto cell = 2 * std::size_t(i);
    const Vec3 &lower = normals_[cell], &upper = normals_[cell + 1];
    const bool rising = cutsRising(*tile_, i, j);
    if (isSharp(lower, upper, cosine))
      rising ? addEdge(i, j, 1, 1) : addEdge(i + 1, j, -1, 1);
    if (j > 0 && isSharp(below_[cell + 1], lower, cosine))
      addEdge(i, j, 1, 0);
    if (i > 0) {
      const Vec3& eastOfWest = normals_[cell - (risingWest ? 2 : 1)];
      if (isSharp(eastOfWest, rising ? upper : lower, cosine))
        addEdge(i, j, 0, 1);
    }
    risingWest = rising;
  }
}

void FeatureTracer::addEdge(int i, int j, int di, int dj) {
  const int direction = directionOf(di, dj);
  sharp_[std::size_t(grid_.index(i, j))] |= std::uint8_t(1 << direction);
  sharp_[std::size_t(grid_.index(i + di, j + dj))] |= std::uint8_t(1 << opposite(direction));
}

/// Takes the edges away that reach a border node where no line may end.
void FeatureTracer::dropForbidden(const std::vector<std::uint8_t>& mayEnd) {
  for (NodeIndex node = 0; node < NodeIndex(grid_.size()); ++node) {
    if (grid_.isInner(node) || mayEnd[std::size_t(node)])
      continue;
    for (int d = 0; d < kDirections; ++d) {
      if (sharp_[std::size_t(node)] >> d & 1) {
        const NodeIndex other =
            grid_.index(grid_.column(node) + kColumnStep[d], grid_.row(node) + kRowStep[d]);
        sharp_[std::size_t(other)] &= std::uint8_t(~(1 << opposite(d)));
      }
    }
    sharp_[std::size_t(node)] = 0;
  }
}

/// Takes an edge from what is unwalked; returns the node at its other end.
NodeIndex FeatureTracer::follow(NodeIndex node, int direction) {
  const NodeIndex other = grid_.index(grid_.column(node) + kColumnStep[direction],
                                      grid_.row(node) + kRowStep[direction]);
  unwalked_[std::size_t(node)] &= std::uint8_t(~(1 << direction));
  unwalked_[std::size_t(other)] &= std::uint8_t(~(1 << opposite(direction)));
  return other;
}

/// Makes a line from a node to the next end or junction, or back to itself.
void FeatureTracer::walk(NodeIndex from, int direction, int minimumEdges) {
  NodeLine line{from};
  NodeIndex node = follow(from, direction);
  line.push_back(node);
  while (node != from && countBits(sharp_[std::size_t(node)]) == 2) {
    node = follow(node, firstBit(unwalked_[std::size_t(node)]));
    line.push_back(node);
  }
  if (int(line.size()) > minimumEdges)
    lines_.push_back(std::move(line));
}

} // namespace qmesh
