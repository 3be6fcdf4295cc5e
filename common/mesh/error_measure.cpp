// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/error_measure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/triangle_spans.h"

namespace qmesh {

namespace {

/// The row tables and vertices a measure works on.
struct DecodedTin {
  std::vector<double> nodeV;
  std::vector<SpanCorner> corners;
};

DecodedTin decodeTin(const TileFrame& frame, const Tin& tin) {
  DecodedTin decoded;
  for (int j = 0; j <= frame.cells(); ++j)
    decoded.nodeV.push_back(frame.nodeV(j));
  decoded.corners.reserve(tin.vertices.size());
  for (const TinVertex& vertex : tin.vertices) {
    const int nearest = frame.nearestRow(vertex.v);
    const int row = nearest + (frame.nodeV(nearest) < vertex.v ? 1 : 0);
    decoded.corners.push_back(
        {spanColumn(vertex.u, frame.cells()), frame.decode(vertex.q), vertex.u, vertex.v, row});
  }
  return decoded;
}

} // namespace

ErrorMeasure measureError(const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
  const DecodedTin decoded = decodeTin(frame, tin);
  const int cells = frame.cells();
  ErrorMeasure measure;
  measure.max = -1;
  for (const TinTriangle& triangle : tin.triangles) {
    const SpanCorner& a = decoded.corners[triangle[0]];
    const SpanCorner& b = decoded.corners[triangle[1]];
    const SpanCorner& c = decoded.corners[triangle[2]];
    const double slope = heightPerColumn(a, b, c, cells);
    const auto visit = [&](int j, int i0, int i1, double height) {
      const float* row = tile.row(j);
      for (int i = i0; i < i1; ++i) {
        const double error = std::abs(height + (i - i0) * slope - row[i]);
        measure.sumSquared += error * error;
        if (error > measure.max) {
          measure.max = error;
          measure.worstColumn = i;
          measure.worstRow = j;
        }
      }
    };
    forEachSpan(a, b, c, decoded.nodeV.data(), cells, slope, visit);
  }
  measure.max = std::max(measure.max, 0.0);
  return measure;
}

} // namespace qmesh
