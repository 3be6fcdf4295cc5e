// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "surface/surface_raster.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "mesh/triangle_spans.h"

namespace qmesh {
namespace {

/// v of row `numerator / denominator` of the matrix's height in the square of `source`.
double positionV(const Scheme& scheme, const GeoBox& box, TileId source, std::int64_t numerator,
                 std::int64_t denominator) {
  if (scheme.profile() == Profile::geodetic) { // as TileFrame has it, free of rounding at nodes
    const std::int64_t rows = scheme.tilesY(source.z);
    const std::int64_t below = std::int64_t(source.y) * (denominator / rows);
    return double(kQuantizedMax) * double(numerator - below) / double(denominator / rows);
  }
  const double latitude = scheme.latitude(numerator, denominator);
  return kQuantizedMax * ((latitude - box.south) / (box.north - box.south));
}

std::vector<SpanCorner> cornersOf(const TileMesh& mesh, const TilePlaces& places) {
  std::vector<SpanCorner> corners;
  corners.reserve(mesh.vertexCount());
  for (std::size_t k = 0; k < mesh.vertexCount(); ++k)
    corners.push_back({places.column(mesh.u[k]), decodedHeight(mesh.header, mesh.q[k]), mesh.u[k],
                       mesh.v[k], places.rowAtOrAbove(mesh.v[k])});
  return corners;
}

/// Writes what the spans of a triangle cover of the raster.
QMESH_INLINE void fillSpans(const SpanList<double>& list, double slope, int side, double* heights) {
  for (int k = 0; k < list.rows && list.firstRow + k < side; ++k) {
    const int begin = std::max(list.begin[k], 0);
    const int end = std::min(list.begin[k] + list.count[k], side);
    double* row = heights + std::size_t(list.firstRow + k) * std::size_t(side);
    for (int column = begin; column < end; ++column)
      row[column] = list.height[k] + double(column - list.begin[k]) * slope;
  }
}

QMESH_VECTOR_CLONES void fillTriangles(const std::vector<SpanCorner>& corners,
                                       const std::vector<std::uint32_t>& indices,
                                       const TilePlaces& places, double* heights) {
  SpanList<double> list;
  const double columnUnits = kQuantizedMax / places.columnsPerTile();
  for (std::size_t k = 0; k < indices.size(); k += 3) {
    const SpanCorner& a = corners[indices[k]];
    const SpanCorner* b = &corners[indices[k + 1]];
    const SpanCorner* c = &corners[indices[k + 2]];
    const std::int64_t area = doubledArea(a, *b, *c);
    if (area == 0)
      continue;
    if (area < 0)
      std::swap(b, c);
    const double slope = heightPerColumn(a, *b, *c, columnUnits);
    listSpans(a, *b, *c, places.rowV().data(), slope, list);
    fillSpans(list, slope, places.side(), heights);
  }
}

} // namespace

TilePlaces::TilePlaces(const Scheme& scheme, TileId tile, TileId source, int cells,
                       Registration registration)
    : side_(registration == Registration::cell ? cells : cells + 1) {
  const int generations = tile.z - source.z;
  assert(generations >= 0 && generations <= kMaxGenerations && cells >= 1 && cells <= 1024);
  assert(tile.x >> generations == source.x && tile.y >> generations == source.y);
  // Places are counted in half cells, so that both registrations are whole numbers.
  const std::int64_t half = registration == Registration::cell ? 1 : 0;
  const std::int64_t columnsWest = std::int64_t(tile.x - (source.x << generations)) * cells;
  columnsPerTile_ = double(std::int64_t(cells) << generations);
  firstColumn_ = double(columnsWest) + 0.5 * double(half);

  const GeoBox box = scheme.box(source);
  const std::int64_t all = 2 * std::int64_t(scheme.tilesY(tile.z)) * cells;
  for (int row = 0; row < side_; ++row)
    rowV_.push_back(
        positionV(scheme, box, source, 2 * (std::int64_t(tile.y) * cells + row) + half, all));
  rowV_.resize(rowV_.size() + kLanePadding, kQuantizedMax);
}

int TilePlaces::rowAtOrAbove(double v) const {
  const auto end = rowV_.begin() + side_;
  return int(std::lower_bound(rowV_.begin(), end, v) - rowV_.begin());
}

std::vector<double> rasterHeights(const TileMesh& mesh, const TilePlaces& places) {
  const int side = places.side();
  std::vector<double> heights(std::size_t(side) * std::size_t(side),
                              std::numeric_limits<double>::quiet_NaN());
  fillTriangles(cornersOf(mesh, places), mesh.indices, places, heights.data());
  return heights;
}

} // namespace qmesh
