// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "grid/height_tile.h"
#include "mesh/triangle_spans.h"

namespace qmesh {

/// Metres for one unit of u and of v; heights are metres already.
struct MetricScale {
  double east = 1;
  double north = 1;
};

/// The tile in metres around its middle, where it is flat enough: a degree of longitude is as long
/// everywhere as on the middle parallel.
MetricScale metricScale(const HeightTile& tile);

/// How the distance of a node from a triangle is measured: straight up or down, or across the
/// triangle's plane, where a slope of angle s leaves cos s of the height.
class ErrorDistance {
 public:
  /// Straight up.
  ErrorDistance() = default;
  /// Across the plane.
  explicit ErrorDistance(const MetricScale& scale) : across_(true), scale_(scale) {}

  bool isHeight() const { return !across_; }

  /// Metres of height that are a metre of distance from a triangle: 1 / cos s, or 1.
  double heightPerDistance(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c) const {
    return across_ ? heightAcross(a, b, c) : 1;
  }

 private:
  double heightAcross(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c) const;

  bool across_ = false;
  MetricScale scale_;
};

} // namespace qmesh
