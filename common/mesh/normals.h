// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "geo/vec3.h"
#include "grid/height_tile.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"

namespace qmesh {

/// Surface normal at node (i, j), 0..N, in the earth-fixed frame: from central differences of the
/// node heights (one-sided at the ends of the lattice and at the outline of the data, where the
/// neighbour is filled and the node is not, or the other way round), in metres of the local
/// east-north-up frame; the ellipsoid's at a pole. The same bits from both tiles that share the
/// node.
Vec3 nodeNormal(const HeightTile& tile, int i, int j);

/// octvertexnormals of the TIN's vertices, two bytes each, in vertex order: each from the node
/// nearest to the vertex.
std::vector<std::uint8_t> octNormals(const HeightTile& tile, const TileFrame& frame,
                                     const Tin& tin);

} // namespace qmesh
