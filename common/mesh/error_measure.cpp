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
  Doubles worst = {};
};

QMESH_INLINE void addErrors(const HeightTile& tile, const SpanList<double>& list, double slope,
                            LaneSums& total) {
  const Masks lanes = {0, 1, 2, 3};
  const Doubles rise = __builtin_convertvector(lanes, Doubles) * slope;
  const int readable = tile.cells() + kTileHalo + 1; // columns of a row that exist
  Doubles squares = total.squares, worst = total.worst;
  for (int r = 0; r < list.rows; ++r) {
    const float* row = tile.row(list.firstRow + r);
    int i = list.begin[r];
    const int end = i + list.count[r];
    Doubles plane = list.height[r] + rise;
    Masks left = Masks{} + list.count[r];
    do { // also for a row without nodes: cheaper than to foresee which one it is
      const float* from = row + i;
      float lastOnes[kLanes] = {};
      if (i + kLanes > readable) {
        std::copy(from, row + readable, lastOnes);
        from = lastOnes;
      }
      Floats heights;
      std::memcpy(&heights, from, sizeof heights);
      Doubles error = plane - __builtin_convertvector(heights, Doubles);
      error = Doubles(Masks(error) & (lanes < left) & 0x7fffffffffffffff);
      squares += error * error;
      worst = error > worst ? error : worst;
      plane += kLanes * slope;
      left -= kLanes;
      i += kLanes;
    } while (i < end);
  }
  total.squares = squares;
  total.worst = worst;
}

QMESH_VECTOR_CLONES void addTriangles(const HeightTile& tile, const DecodedTin& decoded,
                                      const Tin& tin, LaneSums& sums) {
  SpanList<double> list;
  const double columnUnits = unitsPerColumn(tile.cells());
  for (const TinTriangle& triangle : tin.triangles) {
    const SpanCorner& a = decoded.corners[triangle[0]];
    const SpanCorner& b = decoded.corners[triangle[1]];
    const SpanCorner& c = decoded.corners[triangle[2]];
    const double slope = heightPerColumn(a, b, c, columnUnits);
    listSpans(a, b, c, decoded.nodeV.data(), slope, list);
    addErrors(tile, list, slope, sums);
  }
}

} // namespace

ErrorMeasure measureError(const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
  const DecodedTin decoded = decodeTin(frame, tin);
  LaneSums sums;
  addTriangles(tile, decoded, tin, sums);
  ErrorMeasure measure;
  for (int lane = 0; lane < kLanes; ++lane) {
    measure.sumSquared += sums.squares[lane];
    measure.max = std::max(measure.max, double(sums.worst[lane]));
  }
  return measure;
}

} // namespace qmesh
