// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tileset/terrain_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qmesh {
namespace {

/// Columns in x0..x1 sorted by x0, joined where they touch.
std::vector<TileRange> columnRuns(std::vector<TileRange> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const TileRange& a, const TileRange& b) { return a.x0 < b.x0; });
  std::vector<TileRange> runs;
  for (const TileRange& range : ranges) {
    if (!runs.empty() && range.x0 <= std::uint64_t(runs.back().x1) + 1)
      runs.back().x1 = std::max(runs.back().x1, range.x1);
    else
      runs.push_back(range);
  }
  return runs;
}

/// Moves the rectangle to the other side of its widest gap where the tiles meet at the
/// antimeridian.
void goRound(const std::vector<TileRange>& ranges, std::uint32_t columns, TileRange& box) {
  const std::vector<TileRange> runs = columnRuns(ranges);
  if (box.x0 != 0 || box.x1 != columns - 1 || runs.size() < 2)
    return;
  std::size_t widest = 1;
  const auto gapBefore = [&runs](std::size_t k) { return runs[k].x0 - runs[k - 1].x1; };
  for (std::size_t k = 2; k < runs.size(); ++k)
    if (gapBefore(k) > gapBefore(widest))
      widest = k;
  box.x0 = runs[widest].x0;
  box.x1 = columns + runs[widest - 1].x1;
}

/// The number of the tile that holds a fraction of the matrix's edge.
std::uint32_t tileAt(double fraction, std::uint32_t count, bool upperEnd) {
  const double place = std::clamp(fraction, 0.0, 1.0) * count;
  const double tile = upperEnd ? std::ceil(place) - 1 : std::floor(place);
  return std::uint32_t(std::clamp(tile, 0.0, double(count - 1)));
}

TileRange tilesOf(const GeoBox& box, const Scheme& scheme, int zoom) {
  const std::uint32_t columns = scheme.tilesX(zoom), rows = scheme.tilesY(zoom);
  const auto limit = [](double latitude) { return std::clamp(latitude, -89.0, 89.0); };
  const bool mercator = scheme.profile() == Profile::mercator;
  const double south = mercator ? limit(box.south) : box.south;
  const double north = mercator ? limit(box.north) : box.north;
  const TileRange range{tileAt(scheme.fractionX(box.west), columns, false),
                        tileAt(scheme.fractionY(south), rows, false),
                        tileAt(scheme.fractionX(box.east), columns, true),
                        tileAt(scheme.fractionY(north), rows, true)};
  return range.x0 <= range.x1 && range.y0 <= range.y1 ? range
                                                      : TileRange{0, 0, columns - 1, rows - 1};
}

} // namespace

std::optional<TileRange> rasterTiles(const Tileset& set, int zoom) {
  std::optional<TileRange> box = set.available().bounds(zoom);
  if (box)
    goRound(set.available().ranges(zoom), set.scheme().tilesX(zoom), *box);
  else if (zoom > set.available().maxZoom() && zoom <= set.maxZoom())
    box = tilesOf(set.layer().bounds, set.scheme(), zoom);
  return box;
}

/// Where a tile's raster and a window overlap.
struct TerrainRaster::Part {
  TileId tile;
  int side;                 ///< of the tile's raster
  std::int64_t column, row; ///< of the tile's north-west place, in the window
  int width, height;        ///< of the window

  int firstColumn() const { return int(std::max<std::int64_t>(column, 0)); }
  int endColumn() const { return int(std::min<std::int64_t>(column + side, width)); }
  int firstRow() const { return int(std::max<std::int64_t>(row, 0)); }
  int endRow() const { return int(std::min<std::int64_t>(row + side, height)); }

  int columns() const { return std::max(endColumn() - firstColumn(), 0); }
  /// Where a row of the overlap begins in the window.
  std::size_t inWindow(int r) const {
    return std::size_t(r) * std::size_t(width) + std::size_t(firstColumn());
  }
  /// The same place in the tile's raster.
  std::size_t inTile(int r) const {
    return std::size_t(side - 1 - int(r - row)) * std::size_t(side) +
           std::size_t(firstColumn() - column);
  }
};

TerrainRaster::TerrainRaster(TileCache& cache, int cells, Registration registration, Fill fill)
    : cache_(&cache), scheme_(cache.set().scheme()), cells_(cells), registration_(registration),
      fill_(fill), own_(kCapacity), inherited_(kCapacity) {}

Status TerrainRaster::read(int zoom, const RasterWindow& window, float* out) {
  const std::size_t count = std::size_t(window.width) * std::size_t(window.height);
  std::fill_n(out, count, std::numeric_limits<float>::quiet_NaN());
  QMESH_RETURN_IF_ERROR(readPass(zoom, window, /*ancestors=*/false, out));
  if (fill_ == Fill::parent)
    QMESH_RETURN_IF_ERROR(readPass(zoom, window, /*ancestors=*/true, out));
  return {};
}

/// From east to west and from south to north: what is there already is the better choice.
Status TerrainRaster::readPass(int zoom, const RasterWindow& window, bool ancestors, float* out) {
  const std::int64_t reach = registration_ == Registration::node ? 1 : 0; // shared nodes
  const std::int64_t n = cells_, columns = scheme_.tilesX(zoom), rows = scheme_.tilesY(zoom);
  const std::int64_t west = std::max<std::int64_t>(window.column - reach, 0) / n;
  const std::int64_t north = std::max<std::int64_t>(window.row - reach, 0) / n;
  const std::int64_t south = std::min(rows - 1, (window.row + window.height - 1) / n);
  for (std::int64_t y = south; y >= north; --y) {
    for (std::int64_t x = (window.column + window.width - 1) / n; x >= west; --x) {
      const TileId tile{zoom, std::uint32_t(x % columns), std::uint32_t(rows - 1 - y)};
      const Part part{tile,         cells_ + int(reach), x * n - window.column, y * n - window.row,
                      window.width, window.height};
      QMESH_RETURN_IF_ERROR(paste(part, ancestors, out));
    }
  }
  return {};
}

/// Puts a tile's heights where there are none yet.
Status TerrainRaster::paste(const Part& part, bool ancestors, float* out) {
  if (isFull(part, out))
    return {};
  const Result<Heights> heights = ancestors ? ancestorHeights(part.tile) : heightsOf(part.tile);
  if (!heights.ok())
    return heights.status();
  if (!*heights)
    return {};
  for (int r = part.firstRow(); r < part.endRow(); ++r) {
    float* to = out + part.inWindow(r);
    const float* from = (*heights)->data() + part.inTile(r);
    for (int k = 0; k < part.columns(); ++k)
      to[k] = std::isnan(to[k]) ? from[k] : to[k];
  }
  return {};
}

/// True where a part of the window has all its heights.
bool TerrainRaster::isFull(const Part& part, const float* out) {
  for (int r = part.firstRow(); r < part.endRow(); ++r) {
    const float* row = out + part.inWindow(r);
    if (std::any_of(row, row + part.columns(), [](float height) { return std::isnan(height); }))
      return false;
  }
  return true;
}

TerrainRaster::Heights TerrainRaster::evaluate(const TileMesh& mesh, TileId tile, TileId source) {
  return std::make_shared<const std::vector<float>>(
      rasterHeights(mesh, TilePlaces(scheme_, tile, source, cells_, registration_)));
}

Result<TerrainRaster::Heights> TerrainRaster::heightsOf(TileId tile) {
  if (const Heights* known = own_.find(tile))
    return *known;
  const Result<MeshPtr> mesh = cache_->mesh(tile);
  if (!mesh.ok())
    return mesh.status();
  if (!*mesh)
    return Heights();
  const Heights heights = evaluate(**mesh, tile, tile);
  if (registration_ == Registration::node) // only those share places with their neighbours
    own_.put(tile, heights, heights->size() * sizeof(float));
  return heights;
}

Result<TerrainRaster::Heights> TerrainRaster::ancestorHeights(TileId tile) {
  if (const Heights* known = inherited_.find(tile))
    return *known;
  const Result<MeshPtr> own = cache_->mesh(tile);
  if (!own.ok())
    return own.status();
  if (*own)
    return Heights();
  for (TileId up = tile; up.z > 0 && tile.z - up.z < TilePlaces::kMaxGenerations;) {
    up = up.parent();
    const Result<MeshPtr> mesh = cache_->mesh(up);
    if (!mesh.ok())
      return mesh.status();
    if (!*mesh)
      continue;
    const Heights heights = evaluate(**mesh, tile, up);
    inherited_.put(tile, heights, heights->size() * sizeof(float));
    return heights;
  }
  return Heights();
}

} // namespace qmesh
