// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "codec/decode.h"
#include "codec/layer_json.h"
#include "codec/tile_mesh.h"
#include "tileset/tile_address.h"
#include "tileset/tile_reader.h"
#include "tiling/listed_tiles.h"

namespace qmesh {

/// A quantized-mesh set as it lies in a folder, in an archive or on a server, by any producer.
/// Const after open: threads share it.
class Tileset {
 public:
  /// `path`: the folder, its layer.json, either with the prefix "QMESH:", or an http(s) URL of
  /// them (read through /vsicurl/). Code::input with the file and the fault.
  static Result<Tileset> open(const std::string& path);

  /// One .terrain file alone. Its zoom, column and row come from its path, .../z/x/y.terrain; what
  /// else there is to know from the layer.json beside the zoom folders where there is one, else it
  /// is taken for geodetic with rows from the south. Code::input where the path has no numbers.
  static Result<Tileset> openTile(const std::string& path);

  /// The set of a layer.json that the caller has read, and mended perhaps, himself. Code::input
  /// where its tiles cannot be told.
  static Result<Tileset> of(const std::string& layerPath, LayerJson layer);

  const std::string& layerPath() const { return layerPath_; }
  const LayerJson& layer() const { return layer_; }
  Scheme scheme() const { return Scheme(layer_.profile); }
  /// The only tile of a set that openTile() made.
  const std::optional<TileId>& singleTile() const { return single_; }

  /// How its tiles write the lengths of extensions.
  ExtensionLengths extensionLengths() const;

  /// What layer.json lists under "available"; without that key what the metadata of the root tiles
  /// lists ("metadataAvailability") or what lies in the folder.
  const ListedTiles& available() const { return available_; }
  bool lists(TileId tile) const { return available_.contains(tile); }
  /// True where the tile is listed, or its level is deeper than what is known but not than
  /// maxZoom() (sets that list tiles in tiles): only reading tells.
  bool mayHave(TileId tile) const;
  /// The deepest level, -1 for an empty set: of the tiles listed, and "maxzoom" of a set that lists
  /// tiles in tiles.
  int maxZoom() const;

  /// Path or /vsicurl/ URL of a tile.
  std::string tilePath(TileId tile) const;
  /// The file as it is stored; nothing where there is none, Code::input where it cannot be read.
  Result<FileBytes> readBytes(TileId tile) const;
  /// Unpacked where it is gzip and decoded; nothing where there is no file.
  Result<std::optional<TileMesh>> readTile(TileId tile) const;
  /// The mesh in `bytes` of that tile's file.
  Result<TileMesh> decode(TileId tile, const std::vector<std::uint8_t>& bytes) const;

 private:
  Tileset(std::string layerPath, LayerJson layer);

  static Result<Tileset> fromLayer(const std::string& layerPath);
  Status findTiles();
  Status learnFromRoots(std::vector<std::vector<TileRange>>& levels) const;

  std::string layerPath_;
  LayerJson layer_;
  std::shared_ptr<const TileReader> reader_;
  ListedTiles available_;
  std::optional<TileId> single_;
  bool listedInTiles_ = false;
};

} // namespace qmesh
