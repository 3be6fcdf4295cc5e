// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "codec/tile_mesh.h"
#include "validate/finding.h"

namespace qmesh {

/// The vertices on one edge of a tile, from the south or west on: all that is kept of a tile while
/// its neighbours are waited for.
struct TileEdge {
  std::vector<std::uint16_t> at;                    ///< 0..32767 along the edge, ascending
  std::vector<double> heights;                      ///< metres
  std::vector<std::array<std::uint8_t, 2>> normals; ///< empty where the tile has none
  double step = 0; ///< metres between two quantized heights of the tile
};

/// West, south, east, north.
std::array<TileEdge, 4> tileEdges(const TileMesh& mesh);

/// What was seen along seams.
struct SeamReport {
  std::uint64_t seams = 0;
  double largestGap = 0; ///< metres
};

/// Promise P1 for the edge that two tiles share: findings of group `seam`, one a kind.
void checkSeam(const TileEdge& a, const TileEdge& b, const std::string& place, SeamReport& report,
               Findings& findings);

/// The row at a pole is one point: one height for all tiles of the row. `place`: "north pole, ...".
void checkPole(const std::vector<const TileEdge*>& row, const std::string& place,
               Findings& findings);

} // namespace qmesh
