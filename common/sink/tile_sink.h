// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "tiling/scheme.h"

namespace qmesh {

/// Where a tileset goes; TileReader (tileset/tile_reader.h) reads it back. writeTile is called from
/// many threads at once.
class TileSink {
 public:
  virtual ~TileSink() = default;

  /// Stores one tile's file; never visible half-written under its final name.
  virtual Status writeTile(TileId tile, const std::vector<std::uint8_t>& bytes) = 0;
  /// Stores a file beside layer.json (preview page and the like); slashes make folders.
  virtual Status writeFile(const std::string& name, const std::string& text) = 0;
  /// Puts the finished tileset in place, layer.json last. After an error what was there before is
  /// still there.
  virtual Status commit(const std::string& layerJson) = 0;
  /// Removes what was written so far; harmless after commit.
  virtual void abandon() = 0;
};

/// A sink that is ready for tiles.
struct OpenedSink {
  std::unique_ptr<TileSink> sink;
  /// The folder in which the tileset grows, the run's alone: removed by commit and abandon with all
  /// that is in it.
  std::string workFolder;
};

} // namespace qmesh
