// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <vector>

#include "grid/height_tile.h"
#include "mesh/base_grid.h"
#include "mesh/tile_frame.h"
#include "simplify/cgal/node_index.h"

namespace qmesh {

/// Takes nodes out of lines as long as the height error stays within `maxError`, metres, the
/// cheapest first (Dyken, Daehlen & Sevaldrud, "Simultaneous curve simplification", 2009): no line
/// comes to cross another or itself, ends and nodes where lines meet stay, a closed line keeps
/// three nodes, and no piece becomes longer than the base grid permits. Everything happens at
/// the frame's rounded places, where the TIN will be. REQUIRES: the lines meet at nodes only. Order
/// and direction of lines stay.
void simplifyLines(const HeightTile& tile, const TileFrame& frame, const BaseGrid& curvature,
                   double maxError, std::vector<NodeLine>& lines);

} // namespace qmesh
