// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tile_cache.h"

#include <algorithm>
#include <cmath>

namespace qmesh {

std::optional<TilePosition> tileAt(const Scheme& scheme, int zoom, double lon, double lat) {
  constexpr double kUnits = 32767;
  const double turned = lon - 360 * std::floor((lon + 180) / 360); // -180 <= turned < 180
  const double column = scheme.fractionX(turned) * scheme.tilesX(zoom);
  const double row = scheme.fractionY(lat) * scheme.tilesY(zoom);
  if (!(row >= 0 && row <= scheme.tilesY(zoom)))
    return std::nullopt;
  const auto within = [](double at, std::uint32_t count) {
    return std::uint32_t(std::clamp(std::floor(at), 0.0, double(count - 1)));
  };
  TilePosition position;
  position.tile = {zoom, within(column, scheme.tilesX(zoom)), within(row, scheme.tilesY(zoom))};
  const GeoBox box = scheme.box(position.tile);
  position.u = std::clamp((column - position.tile.x) * kUnits, 0.0, kUnits);
  position.v = std::clamp((lat - box.south) / (box.north - box.south) * kUnits, 0.0, kUnits);
  return position;
}

Result<const TileCache::Entry*> TileCache::find(TileId tile) {
  const auto known = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.tile == tile; });
  if (known != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, known);
    return &entries_.front();
  }
  Entry entry;
  entry.tile = tile;
  if (set_->mayHave(tile)) {
    Result<std::optional<TileMesh>> mesh = set_->readTile(tile);
    if (!mesh.ok())
      return mesh.status();
    if (*mesh) {
      entry.mesh = std::make_unique<TileMesh>(*std::move(*mesh));
      entry.search = std::make_unique<SurfaceSearch>(*entry.mesh);
    }
  }
  entries_.push_front(std::move(entry));
  if (entries_.size() > kKept)
    entries_.pop_back();
  return &entries_.front();
}

Result<std::optional<double>> TileCache::heightAt(const TilePosition& position) {
  const Result<const Entry*> entry = find(position.tile);
  if (!entry.ok())
    return entry.status();
  if (!(*entry)->mesh)
    return std::optional<double>();
  return (*entry)->search->heightAt(position.u, position.v);
}

} // namespace qmesh
