// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "surface/surface_raster.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>

#include "mesh/triangle_spans.h"

namespace qmesh {
namespace {

using Doubles = Lanes<double>::Reals;
using Ints = Lanes<double>::Ints;
using Floats = float __attribute__((vector_size(16)));
constexpr int kLanes = Lanes<double>::kCount;

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

/// Writes what the spans of a triangle cover of the raster; of the places behind a span it writes
/// up to four again as they are.
QMESH_INLINE void fillSpans(const SpanList<double>& list, double slope, int side, float* heights) {
  const Ints lanes = {0, 1, 2, 3};
  const int rows = std::min(list.rows, side - list.firstRow);
  float* row = heights + std::ptrdiff_t(list.firstRow) * side;
  for (int k = 0; k < rows; ++k, row += side) {
    int column = std::clamp(list.begin[k], 0, side);
    const int end = std::min(list.begin[k] + list.count[k], side);
    Doubles fromBegin = __builtin_convertvector(lanes + (column - list.begin[k]), Doubles);
    do { // also for a row without places: cheaper than to foresee which one it is
      const Floats plane = __builtin_convertvector(list.height[k] + fromBegin * slope, Floats);
      Floats there;
      std::memcpy(&there, row + column, sizeof there);
      there = lanes < end - column ? plane : there;
      std::memcpy(row + column, &there, sizeof there);
      column += kLanes;
      fromBegin += double(kLanes);
    } while (column < end);
  }
}

QMESH_VECTOR_CLONES void fillTriangles(const std::vector<SpanCorner>& corners,
                                       const std::vector<std::uint32_t>& indices,
                                       const TilePlaces& places, float* heights) {
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
  rowsPerV_ = side_ > 1 ? (side_ - 1) / (rowV_.back() - rowV_.front()) : 0;
  rowV_.resize(rowV_.size() + kLanePadding, kQuantizedMax);
}

int TilePlaces::rowAtOrAbove(double v) const {
  // Right where rows are even.
  int row = int(std::clamp((v - rowV_.front()) * rowsPerV_, 0.0, double(side_)));
  while (row > 0 && rowV_[std::size_t(row) - 1] >= v)
    --row;
  while (row < side_ && rowV_[std::size_t(row)] < v)
    ++row;
  return row;
}

std::vector<float> rasterHeights(const TileMesh& mesh, const TilePlaces& places) {
  const std::size_t count = std::size_t(places.side()) * std::size_t(places.side());
  std::vector<float> heights(count + kLanePadding, std::numeric_limits<float>::quiet_NaN());
  fillTriangles(cornersOf(mesh, places), mesh.indices, places, heights.data());
  heights.resize(count);
  return heights;
}

} // namespace qmesh
