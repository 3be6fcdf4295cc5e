// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>

#include "codec/metadata.h"
#include "validate/tileset_checks.h"

namespace qmesh {

namespace {

bool announces(const LayerJson& layer, const char* name) {
  return std::find(layer.extensions.begin(), layer.extensions.end(), name) !=
         layer.extensions.end();
}

/// Tiles of `ranges` inside `window`; the ranges are disjoint.
std::uint64_t countWithin(const std::vector<TileRange>& ranges, const TileRange& window) {
  std::uint64_t count = 0;
  for (const TileRange& range : ranges) {
    const TileRange common = {std::max(range.x0, window.x0), std::max(range.y0, window.y0),
                              std::min(range.x1, window.x1), std::min(range.y1, window.y1)};
    if (common.x0 <= common.x1 && common.y0 <= common.y1)
      count += common.count();
  }
  return count;
}

/// What metadata and layer.json say about one level below a tile; empty where they agree.
std::string contradiction(const std::vector<TileRange>& metadata,
                          const std::vector<TileRange>& listed, const TileRange& below) {
  for (const TileRange& range : metadata)
    if (countWithin(listed, range) != range.count())
      return "metadata has tiles that \"available\" has not";
  std::uint64_t count = 0;
  for (const TileRange& range : metadata)
    count += countWithin({range}, below);
  if (count != countWithin(listed, below))
    return "\"available\" has tiles that metadata has not";
  return {};
}

void checkMetadata(const std::string& text, const TileContext& context, const LayerJson& layer,
                   const ListedTiles& listed, Findings& findings) {
  const TileId tile = context.tile;
  const auto read = readMetadataJson(text, Scheme(layer.profile), tile);
  if (!read.ok()) {
    findings.push_back({214, context.place, read.status().message()});
    return;
  }
  const auto metadata = ListedTiles::of(*read);
  if (!metadata.ok() || layer.available.empty())
    return;
  for (std::size_t k = 0; k < read->size(); ++k) {
    const int zoom = tile.z + 1 + int(k), deeper = int(k) + 1;
    if (zoom > kMaxZoom)
      break;
    const TileRange below = {tile.x << deeper, tile.y << deeper, ((tile.x + 1) << deeper) - 1,
                             ((tile.y + 1) << deeper) - 1};
    const std::string what = contradiction(metadata->ranges(int(k)), listed.ranges(zoom), below);
    if (what.empty())
      continue;
    findings.push_back({606, context.place, "zoom " + std::to_string(zoom) + ": " + what});
    return;
  }
}

} // namespace

void checkExtensions(const ReadTile& read, const TileContext& context, const LayerJson& layer,
                     const ListedTiles& listed, Findings& findings) {
  const TileMesh& mesh = *read.mesh;
  const auto has = [&](int id) {
    return std::find(read.extensions.begin(), read.extensions.end(), id) != read.extensions.end();
  };
  const auto add = [&](int code) { findings.push_back({code, context.place, ""}); };
  const bool normals = announces(layer, "octvertexnormals") || announces(layer, "vertexnormals");
  const bool water = announces(layer, "watermask");
  if (normals != has(1))
    add(normals ? 607 : 608);
  if (water != has(2))
    add(water ? 609 : 610);
  const int every = layer.metadataAvailability;
  if (has(4) && every == 0)
    add(604);
  if (every > 0 && context.tile.z % every == 0 && context.tile.z < layer.maxZoom && !has(4))
    add(605);
  if (!mesh.extensions.metadata.empty())
    checkMetadata(mesh.extensions.metadata, context, layer, listed, findings);
}

} // namespace qmesh
