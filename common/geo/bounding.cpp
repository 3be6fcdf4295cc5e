// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "geo/bounding.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace qmesh {
namespace {

/// The points that are least and greatest along each axis.
struct Extremes {
  const Vec3* low[3];
  const Vec3* high[3];
};

Extremes findExtremes(const std::vector<Vec3>& points) {
  const Vec3* first = &points.front();
  Extremes e{{first, first, first}, {first, first, first}};
  for (const Vec3& p : points) {
    if (p.x < e.low[0]->x)
      e.low[0] = &p;
    if (p.y < e.low[1]->y)
      e.low[1] = &p;
    if (p.z < e.low[2]->z)
      e.low[2] = &p;
    if (p.x > e.high[0]->x)
      e.high[0] = &p;
    if (p.y > e.high[1]->y)
      e.high[1] = &p;
    if (p.z > e.high[2]->z)
      e.high[2] = &p;
  }
  return e;
}

/// Around the pair of extremes farthest apart, then grown point by point just enough.
Vec3 ritterCentre(const std::vector<Vec3>& points, const Extremes& extremes) {
  int widest = 0;
  double span = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double s = length(*extremes.high[axis] - *extremes.low[axis]);
    if (s > span) {
      span = s;
      widest = axis;
    }
  }
  Vec3 centre = (*extremes.low[widest] + *extremes.high[widest]) * 0.5;
  double radius = span / 2;
  for (const Vec3& p : points) {
    const Vec3 offset = p - centre;
    const double squared = dot(offset, offset);
    if (squared > radius * radius) {
      const double distance = std::sqrt(squared);
      const double grown = (radius + distance) / 2;
      centre = centre + offset * ((grown - radius) / distance);
      radius = grown;
    }
  }
  return centre;
}

double farthest(const std::vector<Vec3>& points, const Vec3& centre) {
  double squared = 0;
  for (const Vec3& p : points) {
    const Vec3 offset = p - centre;
    squared = std::max(squared, dot(offset, offset));
  }
  return std::sqrt(squared);
}

} // namespace

Sphere boundingSphere(const std::vector<Vec3>& points) {
  assert(!points.empty());
  const Extremes e = findExtremes(points);
  const Vec3 middle =
      Vec3{e.low[0]->x + e.high[0]->x, e.low[1]->y + e.high[1]->y, e.low[2]->z + e.high[2]->z} *
      0.5;
  const Vec3 ritter = ritterCentre(points, e);
  const double aroundMiddle = farthest(points, middle);
  const double aroundRitter = farthest(points, ritter);
  const bool takeRitter = aroundRitter < aroundMiddle;
  // A few units in the last place, because clients compute the distance with other roundings.
  const double margin = 1 + 8 * std::numeric_limits<double>::epsilon();
  return {takeRitter ? ritter : middle, std::min(aroundMiddle, aroundRitter) * margin};
}

} // namespace qmesh
