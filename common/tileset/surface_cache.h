// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <optional>

#include "base/lru_cache.h"
#include "surface/surface_search.h"
#include "tileset/tile_cache.h"
#include "tileset/tileset.h"

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
class SurfaceCache {
 public:
  explicit SurfaceCache(const Tileset& set) : set_(&set), surfaces_(kKept) {}

  /// Height in metres of the tile's surface; nothing where there is no tile or no triangle.
  /// Code::input for a tile that cannot be read.
  Result<std::optional<double>> heightAt(const TilePosition& position);

 private:
  static constexpr std::size_t kKept = 96; ///< tiles

  struct Surface {
    explicit Surface(TileMesh decoded) : mesh(std::move(decoded)), search(mesh) {}
    TileMesh mesh;
    SurfaceSearch search; ///< of the mesh
  };
  using SurfacePtr = std::unique_ptr<Surface>; ///< null: there is no such tile

  /// Valid until the next call.
  Result<const Surface*> find(TileId tile);

  const Tileset* set_;
  LruCache<TileId, SurfacePtr, TileIdHash> surfaces_;
};

} // namespace qmesh
