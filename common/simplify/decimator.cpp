// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/decimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simplify/removal_pass.h"

namespace qmesh {

namespace {

/// True where the rounding of a vertex's place, half a unit in u and in v, is worth more height
/// than the tolerance has to spare: three quarters, as a border's rounding may take the last one.
/// Such are the slivers between nodes of one line.
bool isTooSteep(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c, float tolerance) {
  const double bu = b.u - a.u, bv = b.v - a.v, bh = b.height - a.height;
  const double cu = c.u - a.u, cv = c.v - a.v, ch = c.height - a.height;
  const double rise = std::abs(bh * cv - ch * bv) + std::abs(ch * bu - bh * cu);
  return 0.5 * rise > 0.75 * double(tolerance) * (bu * cv - bv * cu);
}

} // namespace

int Decimator::run(Triangulation& mesh, NodeHeights& heights, const BaseGrid& grid, float tolerance,
                   const ErrorDistance& distance) {
  distance_ = distance;
  grid_ = grid;
  return removeVertices(mesh, grid,
                        [&](std::int32_t v) { return tryRemove(mesh, heights, v, tolerance); });
}

bool Decimator::removeAny(Triangulation& mesh, NodeHeights& heights) {
  grid_ = {};
  for (std::int32_t v = 0; v < std::int32_t(mesh.vertices().size()); ++v) {
    if (isInner(mesh.vertex(v).corner) && mesh.leaving(v) != Triangulation::kNone &&
        tryRemove(mesh, heights, v, std::numeric_limits<float>::infinity()))
      return true;
  }
  return false;
}

bool Decimator::tryRemove(Triangulation& mesh, NodeHeights& heights, std::int32_t v,
                          float tolerance) {
  readRing(mesh, v);
  const NodeVertex vertex = mesh.vertex(v);
  // Across the planes a larger error in height may be all right.
  const float limit = distance_.isHeight() ? tolerance : std::numeric_limits<float>::infinity();
  targets_.clear();
  for (std::size_t m = 0; m < ring_.size(); ++m) {
    float error = 0;
    if (fan(m, vertex.corner.height, limit, error))
      targets_.push_back({error, int(m)});
  }
  if (targets_.empty())
    return false;
  // The best fit first: it passes most often, so that one scan is enough.
  std::sort(targets_.begin(), targets_.end(), [](const Target& a, const Target& b) {
    return a.error != b.error ? a.error < b.error : a.ringIndex < b.ringIndex;
  });
  heights.unmask(vertex.i, vertex.j);
  for (const Target& target : targets_) {
    if (isWithin(mesh, heights, std::size_t(target.ringIndex), tolerance)) {
      mesh.collapse(v, ring_[std::size_t(target.ringIndex)].vertex);
      return true;
    }
  }
  heights.mask(vertex.i, vertex.j);
  return false;
}

void Decimator::readRing(const Triangulation& mesh, std::int32_t v) {
  mesh.star(v, star_);
  const SpanCorner& centre = mesh.vertex(v).corner;
  ring_.clear();
  for (const std::int32_t e : star_) {
    const std::int32_t end = mesh.destination(e);
    const SpanCorner& corner = mesh.vertex(end).corner;
    ring_.push_back({end, corner.u - centre.u, corner.v - centre.v, corner.height, 0});
  }
  for (std::size_t k = 0; k < ring_.size(); ++k)
    ring_[k].area = cross(ring_[k], around(k + 1));
}

/// False where corner m of the ring does not see all others or may not be joined to them. Else the
/// fan of triangles from it fills the ring, all of them counter-clockwise: none of their edges
/// exists elsewhere, and the mesh stays manifold. `error`: how far the fan is from the vertex it
/// would replace, of the given height; also false where that is above the limit.
bool Decimator::fan(std::size_t m, double height, float limit, float& error) const {
  const Neighbour& apex = ring_[m];
  std::int32_t toHere = cross(apex, around(m + 1));
  for (std::size_t k = m + 1; k + 1 < m + ring_.size(); ++k) {
    // With the vertex as origin, doubled areas are sums of cross products.
    const Neighbour &a = around(k), &b = around(k + 1);
    const std::int32_t toNext = cross(apex, b);
    const std::int64_t area = std::int64_t(a.area) - toNext + toHere;
    if (area <= 0 || !mayJoin(apex, a))
      return false;
    if (toHere >= 0 && toNext <= 0) {
      error = float(std::abs(
          (a.area * apex.height - toNext * a.height + toHere * b.height) / double(area) - height));
      if (error > limit)
        return false;
    }
    toHere = toNext;
  }
  return true;
}

bool Decimator::isWithin(const Triangulation& mesh, const NodeHeights& heights, std::size_t m,
                         float tolerance) const {
  const SpanCorner& apex = mesh.vertex(ring_[m].vertex).corner;
  for (std::size_t k = m + 1; k + 1 < m + ring_.size(); ++k) {
    const SpanCorner& a = mesh.vertex(around(k).vertex).corner;
    const SpanCorner& b = mesh.vertex(around(k + 1).vertex).corner;
    const auto height = float(tolerance * distance_.heightPerDistance(apex, a, b));
    if (isTooSteep(apex, a, b, height) || !heights.areWithin(apex, a, b, height))
      return false;
  }
  return true;
}

} // namespace qmesh
