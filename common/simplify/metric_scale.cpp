// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/metric_scale.h"

#include <cmath>

#include "geo/ellipsoid.h"

namespace qmesh {

MetricScale metricScale(const HeightTile& tile) {
  const GeoBox box = tile.lattice().scheme().box(tile.id());
  const double latitude = (box.south + box.north) / 2;
  const double degreesEast = (box.east - box.west) / kQuantizedMax;
  const double degreesNorth = (box.north - box.south) / kQuantizedMax;
  return {degreesEast * wgs84::metresPerDegreeEast(latitude),
          degreesNorth * wgs84::metresPerDegreeNorth(latitude)};
}

double ErrorDistance::heightAcross(const SpanCorner& a, const SpanCorner& b,
                                   const SpanCorner& c) const {
  const double bu = b.u - a.u, bv = b.v - a.v, bh = b.height - a.height;
  const double cu = c.u - a.u, cv = c.v - a.v, ch = c.height - a.height;
  const double area = bu * cv - bv * cu;
  const double east = (bh * cv - ch * bv) / (area * scale_.east);
  const double north = (ch * bu - bh * cu) / (area * scale_.north);
  return std::sqrt(1 + east * east + north * north);
}

} // namespace qmesh
