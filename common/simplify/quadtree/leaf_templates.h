// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <vector>

namespace qmesh {

/// The eight places on the outline of a leaf, counter-clockwise from the south-west corner: even
/// ones are corners, odd ones the middles of the sides south, east, north, west.
inline constexpr int kLeafPlaces = 8;

/// A triangle of a leaf by places.
using LeafTriangle = std::array<int, 3>;

/// Bits of the sides whose middle is a vertex.
inline constexpr int kSouthMiddle = 1, kEastMiddle = 2, kNorthMiddle = 4, kWestMiddle = 8;

/// The triangles of a leaf, counter-clockwise, with its corners and the given middles as vertices
/// and no other: neighbours by these templates share whole sides. `rising`: which way the one free
/// diagonal runs where there is a choice, from south-west to north-east (with all four middles:
/// from south to north) or across.
const std::vector<LeafTriangle>& leafTemplate(int middles, bool rising);

} // namespace qmesh
