// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>

#include "base/text.h"
#include "validate/tileset_checks.h"

namespace qmesh {

namespace {

/// A tile of the level `zoom` whose parent is not listed; nothing where there is none. Looks at the
/// parents as rectangles: few, however many tiles.
std::optional<TileId> orphan(const ListedTiles& listed, int zoom) {
  const std::vector<TileRange>& parents = listed.ranges(zoom - 1);
  for (const TileRange& range : listed.ranges(zoom)) {
    const TileRange above = {range.x0 / 2, range.y0 / 2, range.x1 / 2, range.y1 / 2};
    std::uint64_t covered = 0;
    for (const TileRange& parent : parents) {
      const std::int64_t width =
          std::int64_t(std::min(above.x1, parent.x1)) - std::max(above.x0, parent.x0) + 1;
      const std::int64_t height =
          std::int64_t(std::min(above.y1, parent.y1)) - std::max(above.y0, parent.y0) + 1;
      if (width > 0 && height > 0)
        covered += std::uint64_t(width) * std::uint64_t(height);
    }
    if (covered == above.count())
      continue;
    for (std::uint32_t y = range.y0; y <= range.y1; ++y)
      for (std::uint32_t x = range.x0; x <= range.x1; ++x)
        if (!listed.contains({zoom - 1, x / 2, y / 2}))
          return TileId{zoom, x, y};
  }
  return std::nullopt;
}

void checkBounds(const LayerJson& layer, const ListedTiles& listed, Findings& findings) {
  const int zoom = listed.maxZoom();
  const auto tiles = listed.bounds(zoom);
  if (zoom < 1 || !tiles)
    return;
  const Scheme scheme(layer.profile);
  const GeoBox low = scheme.box({zoom, tiles->x0, tiles->y0});
  const GeoBox high = scheme.box({zoom, tiles->x1, tiles->y1});
  const GeoBox& bounds = layer.bounds;
  // Data that ends inside its outermost tiles is as it should be.
  if (low.east > bounds.west && low.north > bounds.south && high.west < bounds.east &&
      high.south < bounds.north)
    return;
  findings.push_back({119, "layer.json",
                      "tiles of zoom " + std::to_string(zoom) + " reach from " +
                          formatNumber(low.west) + " " + formatNumber(low.south) + " to " +
                          formatNumber(high.east) + " " + formatNumber(high.north)});
}

} // namespace

void checkListedTiles(const LayerJson& layer, const ListedTiles& listed, Findings& findings) {
  const auto add = [&](int code, const std::string& place, const std::string& what) {
    findings.push_back({code, place, what});
  };
  const Scheme scheme(layer.profile);
  for (std::uint32_t x = 0; x < scheme.tilesX(0); ++x)
    if (!listed.contains({0, x, 0}))
      add(112, tileName({0, x, 0}), "");
  bool begun = false;
  for (int zoom = 0; zoom < listed.maxZoom(); ++zoom) {
    begun = begun || listed.count(zoom) > 0;
    if (begun && listed.count(zoom) == 0)
      add(111, "layer.json", "zoom " + std::to_string(zoom));
  }
  for (int zoom = 2; zoom <= listed.maxZoom(); ++zoom)
    if (listed.count(zoom - 1) > 0)
      if (const auto tile = orphan(listed, zoom))
        add(603, tileName(*tile), tileName(tile->parent()) + " is not listed");
  checkBounds(layer, listed, findings);
}

} // namespace qmesh
