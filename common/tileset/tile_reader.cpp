// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tileset/tile_reader.h"

#include "base/text.h"
#include "tileset/tile_address.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

/// Files by the pattern of a layer.json.
class AddressedReader : public TileReader {
 public:
  AddressedReader(const std::string& layerPath, const LayerJson& layer)
      : address_(layerPath, layer), scheme_(layer.profile), slippyMap_(layer.slippyMap) {}

  Result<FileBytes> readTile(TileId tile) const override {
    return readWholeFile(pathOf(tile), kMaxTileBytes);
  }
  std::string pathOf(TileId tile) const override { return address_.of(tile); }
  std::vector<std::vector<TileRange>> listTiles() const override;

 private:
  void listColumn(int zoom, std::uint32_t column, const std::string& folder,
                  Availability& found) const;

  TileAddress address_;
  Scheme scheme_;
  bool slippyMap_;
};

std::vector<std::vector<TileRange>> AddressedReader::listTiles() const {
  std::vector<std::vector<TileRange>> levels;
  if (!address_.plainFolders())
    return levels;
  Availability found;
  for (const std::string& z : listFolder(address_.folder())) {
    const auto zoom = parseNumberBelow(z, kMaxZoom + 1);
    if (!zoom)
      continue;
    const std::string zoomFolder = address_.folder() + "/" + z;
    for (const std::string& x : listFolder(zoomFolder))
      if (const auto column = parseNumberBelow(x, scheme_.tilesX(int(*zoom))))
        listColumn(int(*zoom), *column, zoomFolder + "/" + x, found);
  }
  for (int zoom = 0; zoom <= found.maxZoom(); ++zoom)
    levels.push_back(found.ranges(zoom));
  return levels;
}

void AddressedReader::listColumn(int zoom, std::uint32_t column, const std::string& folder,
                                 Availability& found) const {
  const std::uint32_t rows = scheme_.tilesY(zoom);
  for (const std::string& name : listFolder(folder)) {
    const auto row = parseNumberBelow(std::string_view(name).substr(0, name.rfind('.')), rows);
    if (row && name == std::to_string(*row) + ".terrain")
      found.add({zoom, column, slippyMap_ ? rows - 1 - *row : *row});
  }
}

class SingleTileReader : public TileReader {
 public:
  SingleTileReader(TileId tile, std::string path, std::shared_ptr<const TileReader> others)
      : tile_(tile), path_(std::move(path)), others_(std::move(others)) {}

  Result<FileBytes> readTile(TileId tile) const override {
    return tile == tile_ ? readWholeFile(path_, kMaxTileBytes) : others_->readTile(tile);
  }
  std::string pathOf(TileId tile) const override {
    return tile == tile_ ? path_ : others_->pathOf(tile);
  }
  std::vector<std::vector<TileRange>> listTiles() const override {
    std::vector<std::vector<TileRange>> levels(std::size_t(tile_.z) + 1);
    levels.back().push_back({tile_.x, tile_.y, tile_.x, tile_.y});
    return levels;
  }

 private:
  TileId tile_;
  std::string path_;
  std::shared_ptr<const TileReader> others_;
};

} // namespace

std::shared_ptr<const TileReader> openTileReader(const std::string& layerPath,
                                                 const LayerJson& layer) {
  return std::make_shared<AddressedReader>(layerPath, layer);
}

std::shared_ptr<const TileReader> openSingleTile(TileId tile, std::string path,
                                                 std::shared_ptr<const TileReader> others) {
  return std::make_shared<SingleTileReader>(tile, std::move(path), std::move(others));
}

} // namespace qmesh
