// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "tiling/availability.h"

namespace qmesh {

/// The JSON of the metadata extension (id 4) of a tile: under "available" the rectangles of its
/// descendants, by level from the one below the tile, rows from the south.
std::string metadataJson(const std::vector<std::vector<TileRange>>& levels);

/// The inverse, for a tile of any producer: the rectangles of the levels tile.z+1 and on.
/// Code::input where the text is not such JSON or a rectangle lies outside its level's matrix.
Result<std::vector<std::vector<TileRange>>> readMetadataJson(const std::string& text,
                                                             const Scheme& scheme, TileId tile);

} // namespace qmesh
