// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <vector>

#include "border/border.h"
#include "grid/height_tile.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"
#include "simplify/cgal/node_index.h"

namespace qmesh {

/// What a constrained mesh is made of.
struct MeshParts {
  std::vector<NodeIndex> nodes; ///< vertices besides those of the border; each may come repeatedly
  std::vector<NodeLine> lines;  ///< their pieces become edges, their nodes vertices
};

/// The constrained Delaunay triangulation (Chew 1989) of the border's vertices, nodes and lines at
/// their rounded places, with exact predicates. Vertices and triangles only, no measures. False
/// where two lines cross.
bool makeConstrainedMesh(const HeightTile& tile, const TileFrame& frame, const Border& border,
                         const MeshParts& parts, Tin& out);

} // namespace qmesh
