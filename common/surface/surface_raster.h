// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "codec/tile_mesh.h"
#include "tiling/scheme.h"

namespace qmesh {

/// Metres above whatever the set's heights count from, of a quantized height q, 0..32767.
inline double decodedHeight(const TileHeader& header, double q) {
  return double(header.minHeight) +
         q * ((double(header.maxHeight) - double(header.minHeight)) / 32767);
}

/// Where a tile's raster has its places.
enum class Registration {
  cell, ///< in the middle of N x N cells
  node, ///< on the (N+1) x (N+1) nodes of their corners, the tile's border included
};

/// A regular raster of a tile, as positions in the (u, v) of the tile whose mesh is evaluated: the
/// tile itself or an ancestor that stands in for it. Rows are regular in the scheme's own y
/// (latitude, or mercator y) while v is linear in latitude.
class TilePlaces {
 public:
  /// Generations an ancestor may be away: columns of its own width must fit 31 bits.
  static constexpr int kMaxGenerations = 20;

  /// `cells` N: 1..1024. REQUIRES: `source` is `tile` or an ancestor, at most kMaxGenerations up.
  TilePlaces(const Scheme& scheme, TileId tile, TileId source, int cells,
             Registration registration);
  TilePlaces(const Scheme& scheme, TileId tile, int cells, Registration registration)
      : TilePlaces(scheme, tile, tile, cells, registration) {}

  /// Columns, and rows: N or N + 1.
  int side() const { return side_; }
  /// Column coordinate of a position: whole numbers 0..side()-1 on the places.
  double column(double u) const { return u * columnsPerTile_ / 32767 - firstColumn_; }
  /// v of the rows from the south, ascending, and kLanePadding more numbers.
  const std::vector<double>& rowV() const { return rowV_; }
  /// First row at or above v, side() for none.
  int rowAtOrAbove(double v) const;
  /// Columns per 32767 units of u.
  double columnsPerTile() const { return columnsPerTile_; }

 private:
  int side_;
  double columnsPerTile_;
  double firstColumn_;
  double rowsPerV_; ///< on average
  std::vector<double> rowV_;
};

/// Heights of a decoded tile's surface on a raster, metres: rows from the south, each from the
/// west, NaN where no triangle lies. In a proper TIN every place gets its height from exactly one
/// triangle, whatever else touches it. Meshes of any producer: triangles may turn either way, those
/// without area are passed over, of overlapping ones the last counts. Every triangle is walked
/// once: O(triangles + places).
std::vector<float> rasterHeights(const TileMesh& mesh, const TilePlaces& places);

} // namespace qmesh
