// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <list>
#include <memory>
#include <optional>

#include "gdalio/terrain_set.h"
#include "surface/surface_search.h"

namespace qmesh {

/// A place on the globe as a tile's own coordinates.
struct TilePosition {
  TileId tile;
  double u = 0; ///< 0..32767
  double v = 0;
};

/// The tile of a zoom that holds a place; longitude in any turn, latitude -90..90. Nothing beyond
/// the matrix (mercator ends at 85.05 degrees).
std::optional<TilePosition> tileAt(const Scheme& scheme, int zoom, double lon, double lat);

/// Decoded tiles with their surfaces, the last used ones kept. Serves one thread.
class TileCache {
 public:
  explicit TileCache(const TerrainSet& set) : set_(&set) {}

  /// Height in metres of the tile's surface; nothing where there is no tile or no triangle.
  /// Code::input for a tile that cannot be read.
  Result<std::optional<double>> heightAt(const TilePosition& position);

 private:
  static constexpr std::size_t kKept = 96; ///< tiles

  struct Entry {
    TileId tile;
    std::unique_ptr<TileMesh> mesh; ///< null: there is no such tile
    std::unique_ptr<SurfaceSearch> search;
  };

  Result<const Entry*> find(TileId tile);

  const TerrainSet* set_;
  std::list<Entry> entries_; ///< the last used one first
};

} // namespace qmesh
