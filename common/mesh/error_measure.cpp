// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/error_measure.h"

#include <algorithm>
#include <vector>

#include "mesh/triangle_spans.h"

namespace qmesh {

namespace {

using Doubles = Lanes<double>::Reals;
using Masks = Lanes<double>::Masks;
using Floats = float __attribute__((vector_size(16)));
constexpr int kLanes = Lanes<double>::kCount;

/// The vertices and row positions of a TIN as the walk over its triangles wants them.
struct DecodedTin {
  std::vector<double> nodeV;
  std::vector<SpanCorner> corners;
};

DecodedTin decodeTin(const TileFrame& frame, const Tin& tin) {
  DecodedTin decoded;
  for (int j = 0; j <= frame.cells(); ++j)
    decoded.nodeV.push_back(frame.nodeV(j));
  decoded.nodeV.resize(decoded.nodeV.size() + kLanePadding, kQuantizedMax);
  decoded.corners.reserve(tin.vertices.size());
  for (const TinVertex& vertex : tin.vertices) {
    const int nearest = frame.nearestRow(vertex.v);
    const int row = nearest + (frame.nodeV(nearest) < vertex.v ? 1 : 0);
    decoded.corners.push_back(
        {spanColumn(vertex.u, frame.cells()), frame.decode(vertex.q), vertex.u, vertex.v, row});
  }
  return decoded;
}

/// Squares and maxima by lanes, over all triangles.
struct LaneSums {
  Doubles squares = {};
  Doubles worst = Doubles{} - 1.0;
  Masks nodes = {}; ///< j * (N + 1) + i
};

QMESH_INLINE void addErrors(const HeightTile& tile, const SpanList<double>& list, double slope,
                            LaneSums& total) {
  const Masks lanes = {0, 1, 2, 3};
  const Doubles rise = __builtin_convertvector(lanes, Doubles) * slope;
  const int cells = tile.cells();
  const int readable = cells + kTileHalo + 1; // columns of a row that exist
  LaneSums sums = total;
  for (int r = 0; r < list.rows; ++r) {
    const int j = list.firstRow + r;
    const float* row = tile.row(j);
    for (int i = list.begin[r]; i < list.end[r]; i += kLanes) {
      const float* from = row + i;
      float lastOnes[kLanes] = {};
      if (i + kLanes > readable) {
        std::copy(from, row + readable, lastOnes);
        from = lastOnes;
      }
      Floats heights;
      std::memcpy(&heights, from, sizeof heights);
      const double height = list.height[r] + (i - list.begin[r]) * slope;
      Doubles error = (height + rise) - __builtin_convertvector(heights, Doubles);
      const Masks inside = lanes < (Masks{} + (list.end[r] - i));
      error = Doubles(Masks(error) & inside & 0x7fffffffffffffff);
      sums.squares += error * error;
      const Masks worse = (error > sums.worst) & inside;
      sums.worst = worse ? error : sums.worst;
      sums.nodes = worse ? lanes + (j * (cells + 1) + i) : sums.nodes;
    }
  }
  total = sums;
}

QMESH_VECTOR_CLONES void addTriangles(const HeightTile& tile, const DecodedTin& decoded,
                                      const Tin& tin, LaneSums& sums) {
  SpanList<double> list;
  for (const TinTriangle& triangle : tin.triangles) {
    const SpanCorner& a = decoded.corners[triangle[0]];
    const SpanCorner& b = decoded.corners[triangle[1]];
    const SpanCorner& c = decoded.corners[triangle[2]];
    const double slope = heightPerColumn(a, b, c, tile.cells());
    listSpans(a, b, c, decoded.nodeV.data(), slope, list);
    addErrors(tile, list, slope, sums);
  }
}

} // namespace

ErrorMeasure measureError(const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
  LaneSums sums;
  addTriangles(tile, decodeTin(frame, tin), tin, sums);
  ErrorMeasure measure;
  std::int64_t worst = 0;
  for (int lane = 0; lane < kLanes; ++lane) {
    const double error = sums.worst[lane];
    const std::int64_t node = sums.nodes[lane];
    measure.sumSquared += sums.squares[lane];
    if (error > measure.max || (error == measure.max && node < worst)) {
      measure.max = error;
      worst = node;
    }
  }
  measure.worstColumn = int(worst % (tile.cells() + 1));
  measure.worstRow = int(worst / (tile.cells() + 1));
  return measure;
}

} // namespace qmesh
