// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "tiling/availability.h"

namespace qmesh {

/// The JSON of the metadata extension (id 4) of a tile: under "available" one list of ranges for
/// each of the levels tile.z+1 .. tile.z+levels, rows from the south.
std::string metadataJson(const Availability& availability, TileId tile, int levels);

}  // namespace qmesh
