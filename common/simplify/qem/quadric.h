// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "geo/vec3.h"

namespace qmesh {

/// Sum of the squared distances to planes (Garland & Heckbert 1997, section 5): the symmetric 4 x 4
/// matrix of the quadratic form by its ten numbers, and how many planes it holds.
struct Quadric {
  /// Adds the plane normal . x + offset = 0; the normal has unit length.
  void addPlane(const Vec3& normal, double offset) {
    xx += normal.x * normal.x;
    xy += normal.x * normal.y;
    xz += normal.x * normal.z;
    yy += normal.y * normal.y;
    yz += normal.y * normal.z;
    zz += normal.z * normal.z;
    x += normal.x * offset;
    y += normal.y * offset;
    z += normal.z * offset;
    one += offset * offset;
    planes += 1;
  }

  void add(const Quadric& o) {
    xx += o.xx;
    xy += o.xy;
    xz += o.xz;
    yy += o.yy;
    yz += o.yz;
    zz += o.zz;
    x += o.x;
    y += o.y;
    z += o.z;
    one += o.one;
    planes += o.planes;
  }

  /// Sum of squared distances of a point, square metres; never below 0 for rounding.
  double at(const Vec3& p) const {
    const double sum = p.x * (xx * p.x + 2 * (xy * p.y + xz * p.z + x)) +
                       p.y * (yy * p.y + 2 * (yz * p.z + y)) + p.z * (zz * p.z + 2 * z) + one;
    return sum > 0 ? sum : 0;
  }

  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  double x = 0, y = 0, z = 0, one = 0;
  double planes = 0;
};

} // namespace qmesh
