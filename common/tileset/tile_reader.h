// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "codec/layer_json.h"
#include "tiling/availability.h"
#include "vsi/vsi_read.h"

namespace qmesh {

/// Larger files are no tiles: a mesh of all 1025 x 1025 nodes with all extensions has less than
/// 40 MB.
inline constexpr std::size_t kMaxTileBytes = std::size_t(128) << 20;

/// Where the tiles of a tileset are read from: the other side of a TileSink (sink/tile_sink.h).
/// Const; threads share it.
class TileReader {
 public:
  virtual ~TileReader() = default;

  /// A tile's file as it is stored; nothing where there is none, Code::input where it cannot be
  /// read.
  virtual Result<FileBytes> readTile(TileId tile) const = 0;
  /// The tiles that are there, by zoom from 0, found by looking; empty where a place cannot be
  /// listed, as a server.
  virtual std::vector<std::vector<TileRange>> listTiles() const = 0;
  /// Path or URL of a tile, for messages.
  virtual std::string pathOf(TileId tile) const = 0;
};

/// The tiles that a layer.json names, in a folder, in an archive below /vsizip/ or on a server
/// (tile_address.h). `layerPath`: as layerJsonPath() gives it.
std::shared_ptr<const TileReader> openTileReader(const std::string& layerPath,
                                                 const LayerJson& layer);

/// One tile in a file of its own; `others` reads those beside it.
std::shared_ptr<const TileReader> openSingleTile(TileId tile, std::string path,
                                                 std::shared_ptr<const TileReader> others);

} // namespace qmesh
