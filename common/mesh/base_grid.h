// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <limits>

#include "mesh/level_params.h"
#include "mesh/tile_frame.h"
#include "mesh/triangle_spans.h"

namespace qmesh {

/// What a level's base grid (LevelParams::baseGrid) asks of a tile, so that no triangle lies
/// deeper below the ellipsoid than the max error: its nodes are vertices, and no edge is longer
/// than the diagonal of its largest cell. A Delaunay triangulation of the nodes keeps to that by
/// itself, whatever vertices come in addition: an edge is a chord of a circle without a vertex in
/// it. Other meshes have to look. A default one asks for nothing but the corners.
class BaseGrid {
 public:
  BaseGrid() = default;
  BaseGrid(const TileFrame& frame, const LevelParams& level);

  /// Nodes of a finer grid stay as well; edges may be as long as before. A power of two, 1..N.
  void addNodes(int cellsPerEdge);

  /// True where node (i, j) must be a vertex.
  bool isNode(int i, int j) const { return i % step_ == 0 && j % step_ == 0; }

  /// True where two vertices may be joined; exact. All may where one cell is the whole tile.
  bool mayJoin(const SpanCorner& a, const SpanCorner& b) const {
    return isShort(squaredLength(a, b));
  }
  /// The same of the squared length of an edge, quantized units.
  bool isShort(std::int64_t squared) const { return squared <= longest_; }

 private:
  int cells_ = 1;
  int step_ = std::numeric_limits<int>::max(); ///< nodes from one that stays to the next
  std::int64_t longest_ = std::numeric_limits<std::int64_t>::max(); ///< squared
};

} // namespace qmesh
