// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <vector>

#include "tiling/scheme.h"

namespace qmesh {

/// A part of the globe bounded by polygons in degrees (--te, --cutline). A node is inside a polygon
/// by the even-odd rule or on its outline (to 1e-9 degree); it is inside the region when it is
/// inside one polygon. The answer depends on the node's longitude and latitude alone.
class Region {
 public:
  struct Vertex {
    double lon = 0;
    double lat = 0;
  };
  using Ring = std::vector<Vertex>; ///< closed by itself; the first vertex is not repeated

  /// Adds a polygon: outer rings and holes alike. Longitudes may jump by whole turns from vertex to
  /// vertex; a ring that winds around the globe encloses the nearer pole.
  void addPolygon(std::vector<Ring> rings);

  bool empty() const { return polygons_.empty(); }

  /// A box round each polygon: west in -180..180, up to 540 east, as in NodeSourceFactory::extent.
  std::vector<GeoBox> boxes() const;

  /// Sets the values of the row's nodes outside the region to NaN; `longitudes` in -180..180.
  void clearOutside(double latitude, const double* longitudes, int count, float* values) const;

 private:
  struct Edge {
    Vertex a, b; ///< a.lat <= b.lat
  };
  struct Polygon {
    GeoBox box;
    std::vector<Edge> edges;
  };
  struct Span {
    double west, east;
  };

  static void addSpans(const Polygon& polygon, double latitude, std::vector<Span>& spans);

  std::vector<Polygon> polygons_;
};

} // namespace qmesh
