// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/metric_nodes.h"

#include "geo/ellipsoid.h"

namespace qmesh {

void MetricNodes::reset(const HeightTile& tile) {
  tile_ = &tile;
  columns_.clear();
  rows_.clear();
  for (int k = 0; k <= tile.cells(); ++k) {
    const Vec3 east = wgs84::normal(tile.lattice().longitude(tile.column0() + k), 0);
    columns_.push_back({east.x, east.y});
    const double latitude = tile.lattice().latitude(tile.row0() + k);
    const Vec3 up = wgs84::normal(0, latitude), foot = wgs84::toEcef(0, latitude, 0);
    rows_.push_back({foot.x, foot.z, up.x, up.z});
  }
}

} // namespace qmesh
