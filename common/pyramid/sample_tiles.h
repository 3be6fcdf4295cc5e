// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "grid/node_window.h"
#include "pyramid/pyramid_plan.h"

namespace qmesh {

/// A level's tiles where these are `most` or fewer; else so many spread over it by the golden
/// section (even steps would fall on one column, the rim of the data perhaps), some perhaps twice.
std::vector<TileId> spreadTiles(const Availability& tiles, int zoom, std::uint64_t most);

/// Fills the window with one tile of the lattice `nodes` was opened for, sampled at that level,
/// voids filled with the constant of --void-fill.
Status sampleTile(const TilesetInput& input, NodeSource& nodes, TileId id, NodeWindow& window);

} // namespace qmesh
