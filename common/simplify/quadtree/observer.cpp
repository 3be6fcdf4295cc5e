// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/quadtree/observer.h"

#include <algorithm>
#include <cmath>

#include "geo/ellipsoid.h"

namespace qmesh {

Observer::Observer(const MethodOptions& options)
    : place_(options.observer), range_(options.observerRange) {
  if (place_)
    position_ = wgs84::toEcef((*place_)[0], (*place_)[1], (*place_)[2]);
}

double Observer::factor(const HeightTile& tile, int i, int j, int across, int up) const {
  if (!place_)
    return 1;
  const NodeLattice& lattice = tile.lattice();
  const double west = lattice.longitude(tile.column0() + i);
  const double width = across * lattice.spacingDegrees();
  double eastward = std::fmod((*place_)[0] - west, 360); // of the observer from the west side
  if (eastward < 0)
    eastward += 360;
  const bool nearerEast = eastward - width < 360 - eastward;
  const double longitude = eastward <= width ? (*place_)[0] : nearerEast ? west + width : west;
  const double south = lattice.latitude(tile.row0() + j);
  const double north = lattice.latitude(tile.row0() + j + up);
  const double latitude = std::clamp((*place_)[1], south, north);
  const double distance = length(wgs84::toEcef(longitude, latitude, 0) - position_);
  return std::max(1.0, distance / range_);
}

} // namespace qmesh
