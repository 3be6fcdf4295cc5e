// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "simplify/cgal/collapse_mesh.h"
#include "simplify/decimator.h"
#include "simplify/node_heights.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// Takes the inner nodes out of a start mesh that the heights do not need within a small tolerance
/// (Decimator): several times fewer edges for CGAL to look at, and as good a result, because
/// the judge still looks at every node. Memory is kept from tile to tile.
class MeshThinning {
 public:
  /// `tolerance`: metres. The border's vertices and the grid's stay, and no edge becomes longer
  /// than the grid permits. The order of vertices is kept.
  void run(const HeightTile& tile, const TileFrame& frame, const BaseGrid& grid, double tolerance,
           CollapseMesh& mesh);

 private:
  void load(const HeightTile& tile, const TileFrame& frame, const CollapseMesh& mesh);
  void store(CollapseMesh& mesh);

  std::vector<NodeVertex> vertices_;
  std::vector<std::int32_t> alive_;
  Triangulation triangulation_;
  NodeHeights heights_;
  Decimator decimator_;
};

} // namespace qmesh
