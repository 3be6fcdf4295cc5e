// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/lru_cache.h"
#include "surface/surface_raster.h"
#include "tileset/tile_cache.h"

namespace qmesh {

/// What stands where a set has no tile.
enum class Fill {
  nodata, ///< nothing
  parent, ///< the surface of the deepest ancestor there is
};

/// A rectangle of a level's cells or nodes: columns from longitude -180 (they may run beyond the
/// east end of the matrix, where it begins again), rows from the north.
struct RasterWindow {
  std::int64_t column = 0;
  std::int64_t row = 0;
  int width = 0;
  int height = 0;
};

/// Every level of a set as a regular raster of heights: N cells per tile edge, or the N + 1 nodes
/// of their corners. Serves one thread.
class TerrainRaster {
 public:
  /// `cache` must outlive the raster; `cells` N: 1..1024.
  TerrainRaster(TileCache& cache, int cells, Registration registration, Fill fill);

  int cells() const { return cells_; }

  /// Heights in metres into `out`, rows from the north, NaN where there is none. A node on the
  /// border of tiles is the one of the tile east and south of it, where that is missing of another.
  /// Decodes the tiles that the window meets and no other. Code::input for a tile that cannot be
  /// used.
  Status read(int zoom, const RasterWindow& window, float* out);

 private:
  using Heights = std::shared_ptr<const std::vector<float>>;      ///< null: no tile
  static constexpr std::size_t kCapacity = std::size_t(32) << 20; ///< bytes

  struct Part;
  Status readPass(int zoom, const RasterWindow& window, bool ancestors, float* out);
  Status paste(const Part& part, bool ancestors, float* out);
  static bool isFull(const Part& part, const float* out);
  Result<Heights> heightsOf(TileId tile);
  Result<Heights> ancestorHeights(TileId tile);
  Heights evaluate(const TileMesh& mesh, TileId tile, TileId source);

  TileCache* cache_;
  Scheme scheme_;
  int cells_;
  Registration registration_;
  Fill fill_;
  LruCache<TileId, Heights, TileIdHash> own_, inherited_;
};

/// The part of a level that its raster covers: the smallest rectangle around the tiles. x1 is
/// beyond the last column where the tiles lie on both sides of the antimeridian and a gap is
/// elsewhere. Of a level that is deeper than what is known: the tiles that meet "bounds". Nothing
/// where the set cannot have tiles there.
std::optional<TileRange> rasterTiles(const Tileset& set, int zoom);

} // namespace qmesh
