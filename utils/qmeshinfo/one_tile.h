// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "qmeshinfo/info_options.h"
#include "tileset/tileset.h"
#include "validate/tile_bytes.h"

namespace qmesh {

/// All there is to say about one tile.
struct TileReport {
  TileId tile;
  std::string path;
  GeoBox box;
  std::size_t storedBytes = 0;
  ReadTile read;                  ///< has a mesh
  Findings findings;              ///< about its bytes
  double lowest = 0, highest = 0; ///< metres, of the vertices
};

/// Code::input where the tile is not in the matrix, there is no file or no mesh can be read from
/// it.
Result<TileReport> describeTile(const Tileset& set, TileId tile);

/// Writes --export and --draw. Code::output.
Status exportTile(const TileReport& report, const InfoOptions& options);

} // namespace qmesh
