// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tileset/tileset.h"

#include <algorithm>

#include "base/text.h"
#include "codec/decode.h"
#include "codec/gzip.h"
#include "codec/metadata.h"

namespace qmesh {
namespace {

constexpr std::size_t kMaxLayer = std::size_t(256) << 20; ///< bytes
using Levels = std::vector<std::vector<TileRange>>;

bool contains(const std::vector<std::string>& words, const char* word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Status about(const std::string& path, const Status& status) {
  return {status.code(), "'" + path + "': " + status.message()};
}

Result<LayerJson> parseLayer(const std::string& path, std::vector<std::uint8_t> bytes) {
  if (isGzip(bytes.data(), bytes.size())) {
    auto unpacked = gunzip(bytes.data(), bytes.size(), kMaxLayer);
    if (!unpacked.ok())
      return about(path, unpacked.status());
    bytes = std::move(*unpacked);
  }
  Result<LayerJson> layer = readLayerJson(std::string(bytes.begin(), bytes.end()));
  return layer.ok() ? std::move(layer) : Result<LayerJson>(about(path, layer.status()));
}

std::string_view withoutExtension(std::string_view name) {
  return name.substr(0, name.rfind('.'));
}

/// The last piece of a path, which loses it.
std::string_view takeName(std::string_view& path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view name = slash == path.npos ? path : path.substr(slash + 1);
  path = path.substr(0, slash == path.npos ? 0 : slash);
  return name;
}

/// Zoom, column and row as the path writes them, and the folder of the zoom folders.
struct TilePlace {
  TileId written;
  std::string folder;
};

std::optional<TilePlace> placeOf(const std::string& path) {
  std::string_view rest = path;
  rest = rest.substr(0, rest.find('?'));
  const std::string_view y = withoutExtension(takeName(rest));
  const std::string_view x = takeName(rest);
  const std::string_view z = takeName(rest);
  const auto zoom = parseNumberBelow(z, kMaxZoom + 1);
  const auto column = parseNumberBelow(x, std::int64_t(1) << (kMaxZoom + 1));
  const auto row = parseNumberBelow(y, std::int64_t(1) << kMaxZoom);
  if (!zoom || !column || !row)
    return std::nullopt;
  return TilePlace{{int(*zoom), *column, *row}, rest.empty() ? "." : std::string(rest)};
}

} // namespace

Tileset::Tileset(std::string layerPath, LayerJson layer)
    : layerPath_(std::move(layerPath)), layer_(std::move(layer)),
      reader_(openTileReader(layerPath_, layer_)) {}

Result<Tileset> Tileset::open(const std::string& path) {
  Result<Tileset> set = fromLayer(layerJsonPath(path));
  if (set.ok())
    QMESH_RETURN_IF_ERROR(set->findTiles());
  return set;
}

Result<Tileset> Tileset::of(const std::string& layerPath, LayerJson layer) {
  Tileset set(layerPath, std::move(layer));
  QMESH_RETURN_IF_ERROR(set.findTiles());
  return set;
}

Result<Tileset> Tileset::fromLayer(const std::string& layerPath) {
  Result<FileBytes> bytes = readWholeFile(layerPath, kMaxLayer);
  if (!bytes.ok())
    return bytes.status();
  if (!*bytes)
    return Status(Code::input, "there is no '" + layerPath + "'");
  Result<LayerJson> layer = parseLayer(layerPath, std::move(**bytes));
  if (!layer.ok())
    return layer.status();
  return Tileset(layerPath, std::move(*layer));
}

Result<Tileset> Tileset::openTile(const std::string& path) {
  const auto place = placeOf(path);
  if (!place)
    return Status(Code::input, "'" + path +
                                   "' does not say which tile it is: its path must end in "
                                   "zoom/column/row.terrain");
  Result<Tileset> set = fromLayer(layerJsonPath(place->folder));
  if (!set.ok())
    set = Tileset(layerJsonPath(place->folder), LayerJson());
  TileId tile = place->written;
  const Scheme scheme = set->scheme();
  if (tile.x >= scheme.tilesX(tile.z) || tile.y >= scheme.tilesY(tile.z))
    return Status(Code::input, "'" + path + "' is not a tile: zoom " + std::to_string(tile.z) +
                                   " has only " + std::to_string(scheme.tilesX(tile.z)) + " x " +
                                   std::to_string(scheme.tilesY(tile.z)));
  if (set->layer_.slippyMap)
    tile.y = scheme.tilesY(tile.z) - 1 - tile.y;
  set->single_ = tile;
  set->reader_ = openSingleTile(tile, path, set->reader_);
  Result<ListedTiles> listed = ListedTiles::of(set->reader_->listTiles());
  set->available_ = std::move(*listed);
  return set;
}

Status Tileset::findTiles() {
  Levels levels = layer_.available;
  if (levels.empty() && layer_.metadataAvailability > 0)
    QMESH_RETURN_IF_ERROR(learnFromRoots(levels));
  else if (levels.empty())
    levels = reader_->listTiles();
  Result<ListedTiles> listed = ListedTiles::of(levels);
  if (!listed.ok())
    return about(layerPath_, listed.status());
  available_ = std::move(*listed);
  listedInTiles_ = layer_.metadataAvailability > 0;
  return {};
}

Status Tileset::learnFromRoots(Levels& levels) const {
  levels.resize(1);
  for (std::uint32_t x = 0; x < scheme().tilesX(0); ++x) {
    const TileId root{0, x, 0};
    const Result<std::optional<TileMesh>> mesh = readTile(root);
    if (!mesh.ok())
      return mesh.status();
    if (!*mesh)
      continue;
    levels[0].push_back({x, 0, x, 0});
    const auto below = readMetadataJson((*mesh)->extensions.metadata, scheme(), root);
    if (!below.ok())
      continue; // a tile without it tells nothing about those below
    levels.resize(std::max(levels.size(), below->size() + 1));
    for (std::size_t k = 0; k < below->size(); ++k)
      levels[k + 1].insert(levels[k + 1].end(), (*below)[k].begin(), (*below)[k].end());
  }
  return {};
}

/// CesiumJS: only the old name alone means the old byte order.
ExtensionLengths Tileset::extensionLengths() const {
  const bool old = contains(layer_.extensions, "vertexnormals") &&
                   !contains(layer_.extensions, "octvertexnormals");
  return old ? ExtensionLengths::bigEndian : ExtensionLengths::littleEndian;
}

bool Tileset::mayHave(TileId tile) const {
  return lists(tile) ||
         (listedInTiles_ && tile.z > available_.maxZoom() && tile.z <= layer_.maxZoom);
}

int Tileset::maxZoom() const {
  return listedInTiles_ ? std::max(available_.maxZoom(), layer_.maxZoom) : available_.maxZoom();
}

std::string Tileset::tilePath(TileId tile) const {
  return reader_->pathOf(tile);
}

Result<FileBytes> Tileset::readBytes(TileId tile) const {
  return reader_->readTile(tile);
}

Result<std::optional<TileMesh>> Tileset::readTile(TileId tile) const {
  const Result<FileBytes> bytes = readBytes(tile);
  if (!bytes.ok())
    return bytes.status();
  if (!*bytes)
    return std::optional<TileMesh>();
  Result<TileMesh> mesh = decode(tile, **bytes);
  if (!mesh.ok())
    return mesh.status();
  return std::optional<TileMesh>(std::move(*mesh));
}

Result<TileMesh> Tileset::decode(TileId tile, const std::vector<std::uint8_t>& bytes) const {
  const ExtensionLengths lengths = extensionLengths();
  Result<TileMesh> mesh = [&]() -> Result<TileMesh> {
    if (!isGzip(bytes.data(), bytes.size()))
      return decodeTile(bytes.data(), bytes.size(), lengths);
    const auto unpacked = gunzip(bytes.data(), bytes.size(), kMaxTileBytes);
    if (!unpacked.ok())
      return unpacked.status();
    return decodeTile(unpacked->data(), unpacked->size(), lengths);
  }();
  return mesh.ok() ? std::move(mesh) : Result<TileMesh>(about(tilePath(tile), mesh.status()));
}

} // namespace qmesh
