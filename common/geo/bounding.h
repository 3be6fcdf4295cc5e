// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "geo/vec3.h"

namespace qmesh {

struct Sphere {
  Vec3 centre;
  double radius = 0;
};

/// A sphere that holds all points (radius rounded up so that it does so in floating point):
/// the smaller of Ritter's sphere (Ritter 1990) and the one around the middle of the box.
/// REQUIRES: at least one point.
Sphere boundingSphere(const std::vector<Vec3>& points);

/// The horizon occlusion point of a tile, in units of the ellipsoid's radii (scaled space), as
/// the quantized-mesh header wants it: on the ray towards `direction` (ECEF, the centre of the
/// bounding sphere), so that where it is below the horizon all points are.
/// Ring, "Horizon culling" (Cesium blog, 2013). A point below the ellipsoid counts as on it.
/// Where no finite point exists (a tile that spans half a globe) a point so far out that it is
/// never below the horizon; never NaN or infinite.
Vec3 horizonOcclusionPoint(const Vec3& direction, const std::vector<Vec3>& points);

} // namespace qmesh
