// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cmath>

#include "grid/height_tile.h"

namespace qmesh {

/// How the mesh of all nodes cuts the cell with the south-west node (i, j): along the diagonal
/// whose ends differ less in height. True for the one from south-west to north-east.
inline bool cutsRising(const HeightTile& tile, int i, int j) {
  const float rising = std::abs(tile.at(i + 1, j + 1) - tile.at(i, j));
  const float falling = std::abs(tile.at(i, j + 1) - tile.at(i + 1, j));
  return rising <= falling;
}

} // namespace qmesh
