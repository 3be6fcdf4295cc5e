// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/vertex_removal.h"

#include "simplify/removal_pass.h"

namespace qmesh {

int VertexRemoval::run(Triangulation& mesh, const NodeHeights& heights, const BaseGrid& grid,
                       float tolerance) {
  grid_ = grid;
  return removeVertices(mesh, grid,
                        [&](std::int32_t v) { return tryRemove(mesh, heights, v, tolerance); });
}

bool VertexRemoval::tryRemove(Triangulation& mesh, const NodeHeights& heights, std::int32_t v,
                              float tolerance) {
  mesh.star(v, star_);
  ring_.clear();
  left_.clear();
  fill_.clear();
  for (const std::int32_t e : star_) {
    left_.push_back(std::int32_t(ring_.size()));
    ring_.push_back(mesh.destination(e));
  }
  while (left_.size() > 2) {
    const int ear = bestEar(mesh, heights, tolerance);
    if (ear < 0)
      return false;
    const std::size_t k = std::size_t(ear), count = left_.size();
    fill_.push_back({left_[(k + count - 1) % count], left_[k], left_[(k + 1) % count]});
    left_.erase(left_.begin() + ear);
  }
  mesh.remove(v, fill_);
  return true;
}

/// The ear with the shortest base that holds the tolerance and may be cut; -1 where there is none.
int VertexRemoval::bestEar(const Triangulation& mesh, const NodeHeights& heights,
                           float tolerance) const {
  int best = -1;
  std::int64_t shortest = 0;
  for (std::size_t k = 0; k < left_.size(); ++k) {
    const SpanCorner& before = corner(mesh, k + left_.size() - 1);
    const SpanCorner& after = corner(mesh, k + 1);
    const std::int64_t length = squaredLength(before, after);
    if ((best < 0 || length < shortest) && grid_.isShort(length) && isEar(mesh, k) &&
        heights.areWithin(before, corner(mesh, k), after, tolerance)) {
      best = int(k);
      shortest = length;
    }
  }
  return best;
}

/// Corner k and its two neighbours make a counter-clockwise triangle with no other corner in it or
/// on its edges.
bool VertexRemoval::isEar(const Triangulation& mesh, std::size_t k) const {
  const SpanCorner& a = corner(mesh, k + left_.size() - 1);
  const SpanCorner& b = corner(mesh, k);
  const SpanCorner& c = corner(mesh, k + 1);
  if (doubledArea(a, b, c) <= 0)
    return false;
  for (std::size_t other = k + 2; other + 1 < k + left_.size(); ++other) {
    const SpanCorner& p = corner(mesh, other);
    if (doubledArea(a, b, p) >= 0 && doubledArea(b, c, p) >= 0 && doubledArea(c, a, p) >= 0)
      return false;
  }
  return true;
}

} // namespace qmesh
