// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/finish.h"

#include <algorithm>

#include "mesh/error_measure.h"

namespace qmesh {

namespace {

std::int64_t areaOf(const Tin& tin, const TinTriangle& t) {
  const TinVertex &a = tin.vertices[t[0]], &b = tin.vertices[t[1]], &c = tin.vertices[t[2]];
  return std::int64_t(b.u - a.u) * (c.v - a.v) - std::int64_t(b.v - a.v) * (c.u - a.u);
}

} // namespace

void avoidForbiddenVertexCount(const TileFrame& frame, Tin& tin) {
  if (tin.vertices.size() != kForbiddenVertexCount)
    return;
  const auto largest = std::max_element(
      tin.triangles.begin(), tin.triangles.end(),
      [&](const auto& a, const auto& b) { return areaOf(tin, a) < areaOf(tin, b); });
  const TinTriangle t = *largest;
  const TinVertex &a = tin.vertices[t[0]], &b = tin.vertices[t[1]], &c = tin.vertices[t[2]];
  const double height = (frame.decode(a.q) + frame.decode(b.q) + frame.decode(c.q)) / 3;
  const TinVertex middle{std::uint16_t((a.u + b.u + c.u) / 3), std::uint16_t((a.v + b.v + c.v) / 3),
                         frame.quantize(float(height))};
  const auto added = std::uint32_t(tin.vertices.size());
  tin.vertices.push_back(middle);
  *largest = {t[0], t[1], added};
  tin.triangles.push_back({t[1], t[2], added});
  tin.triangles.push_back({t[2], t[0], added});
}

void finishTin(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
               StopReason reason, Tin& tin) {
  avoidForbiddenVertexCount(frame, tin);
  const ErrorMeasure measure = measureError(tile, frame, tin);
  tin.maxError = measure.max;
  tin.sumSquaredError = measure.sumSquared;
  const bool missed = reason == StopReason::maxError && measure.max > level.maxError;
  tin.reason = missed ? StopReason::quantization : reason;
}

} // namespace qmesh
