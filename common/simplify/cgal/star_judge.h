// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <optional>
#include <vector>

#include "mesh/base_grid.h"
#include "simplify/cgal/collapse_mesh.h"
#include "simplify/node_heights.h"

namespace qmesh {

/// Says whether an edge may collapse to a vertex: judged is what would be written. No new triangle
/// may be flipped or degenerate in (u, v) or have an edge longer than the base grid permits;
/// where an error is given no node of them may be off by
/// more.
class StarJudge {
 public:
  /// `maxError`: metres. REQUIRES: tile, frame and mesh live as long as this is used.
  void reset(const HeightTile& tile, const TileFrame& frame, const Border& border,
             const BaseGrid& grid, const CollapseMesh& mesh, std::optional<double> maxError);

  /// The edge from vertex `first` to `second` becomes `placed`; `star`: the triangles around both.
  bool accepts(std::uint32_t first, std::uint32_t second, const CollapseVertex& placed,
               const std::vector<TinTriangle>& star) const;

  /// What it looks at. REQUIRES: a max error was given.
  const NodeHeights& heights() const { return heights_; }
  float tolerance() const { return *tolerance_; }

 private:
  const CollapseMesh* mesh_ = nullptr;
  BaseGrid grid_;
  std::optional<float> tolerance_;
  NodeHeights heights_;
};

} // namespace qmesh
