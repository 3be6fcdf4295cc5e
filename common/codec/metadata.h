// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "tiling/availability.h"

namespace qmesh {

/// The JSON of the metadata extension (id 4) of a tile: under "available" one list of ranges for
/// each of the levels tile.z+1 .. tile.z+levels, rows from the south.
std::string metadataJson(const Availability& availability, TileId tile, int levels);

/// The inverse, for a tile of any producer: the rectangles of the levels tile.z+1 and on.
/// Code::input where the text is not such JSON or a rectangle lies outside its level's matrix.
Result<std::vector<std::vector<TileRange>>> readMetadataJson(const std::string& text,
                                                             const Scheme& scheme, TileId tile);

} // namespace qmesh
