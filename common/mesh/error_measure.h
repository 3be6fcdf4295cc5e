// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "grid/height_tile.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"

namespace qmesh {

/// How far a TIN is from the nodes it stands for.
struct ErrorMeasure {
  double max = 0;        ///< metres
  double sumSquared = 0; ///< square metres, each of the (N+1)^2 nodes once
};

/// Evaluates the decoded TIN in double precision at every node of the tile, borders included. A
/// node on an edge or vertex counts in one triangle only.
/// REQUIRES: the TIN covers the square.
ErrorMeasure measureError(const HeightTile& tile, const TileFrame& frame, const Tin& tin);

} // namespace qmesh
