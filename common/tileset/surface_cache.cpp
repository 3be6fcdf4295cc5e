// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tileset/surface_cache.h"

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

Result<const SurfaceCache::Surface*> SurfaceCache::find(TileId tile) {
  if (const SurfacePtr* known = surfaces_.find(tile))
    return known->get();
  SurfacePtr surface;
  if (set_->mayHave(tile)) {
    Result<std::optional<TileMesh>> mesh = set_->readTile(tile);
    if (!mesh.ok())
      return mesh.status();
    if (*mesh)
      surface = std::make_unique<Surface>(*std::move(*mesh));
  }
  const Surface* found = surface.get();
  surfaces_.put(tile, std::move(surface), 1);
  return found;
}

Result<std::optional<double>> SurfaceCache::heightAt(const TilePosition& position) {
  const Result<const Surface*> surface = find(position.tile);
  if (!surface.ok())
    return surface.status();
  if (!*surface)
    return std::optional<double>();
  return (*surface)->search.heightAt(position.u, position.v);
}

} // namespace qmesh
