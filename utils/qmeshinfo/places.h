// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tileset/tileset.h"

namespace qmesh {

/// A place asked for and what the terrain says there.
struct Sample {
  double lon = 0;
  double lat = 0;
  std::optional<double> height; ///< metres; nothing where no tile has a surface
  TileId tile;                  ///< the one the height is from
};

/// Heights of the deepest tile there is at each place, no deeper than `lastZoom`. `texts`:
/// "LON,LAT", or "-" for lines of standard input. Code::usage for a text that is no place,
/// Code::input for a tile that cannot be read.
Result<std::vector<Sample>> samplePlaces(const Tileset& set, int lastZoom,
                                         const std::vector<std::string>& texts);

} // namespace qmesh
