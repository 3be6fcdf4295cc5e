// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "simplify/simplifier.h"

namespace qmesh {

/// --border inherit: makes a border ready for the simplifier. Edges that are not free were built by
/// neighbours and stay. A free edge that the method may choose begins with the nodes of the
/// base grid; the others become what --border shared has and final: all of a method that does
/// not choose, a pole's row (one point for every tile of it), and the edges of a tile that goes
/// round the globe and is its own neighbour.
void completeBorder(const Simplifier& simplifier, const HeightTile& tile, const TileFrame& frame,
                    const LevelParams& level, Border& border);

/// The border a TIN has: what its neighbours inherit. No edge is free.
void listBorder(const Tin& tin, Border& border);

} // namespace qmesh
