// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cmath>
#include <limits>

#include "geo/bounding.h"
#include "geo/ellipsoid.h"

namespace qmesh {
namespace {

/// So far that the square of the distance overflows: the visibility test of CesiumJS then compares
/// with NaN, finds the point not hidden, and the tile is always drawn. A point at a merely large
/// distance is hidden from viewers near the ground of the opposite side.
constexpr double kFar = 1e200;

/// Below this cosine the tile reaches a right angle away from the direction.
constexpr double kLeastCosine = 1e-12;

Vec3 toScaledSpace(const Vec3& ecef) {
  return {ecef.x / wgs84::kSemiMajor, ecef.y / wgs84::kSemiMajor, ecef.z / wgs84::kSemiMinor};
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Cosine of the angle between `direction` (unit, scaled space) and the spot where the line of
/// sight that just grazes the unit sphere on its way to the point touches it, on the point's far
/// side. That angle is alpha, from the direction to the point, plus beta, from the point to the
/// spot.
double grazingCosine(const Vec3& direction, const Vec3& ecef) {
  const Vec3 p = toScaledSpace(ecef);
  const double magnitude = length(p);
  const double cosAlpha = dot(p, direction) / magnitude;
  const double sinAlpha = length(cross(p, direction)) / magnitude;
  const double outside = std::max(1.0, magnitude);
  const double cosBeta = 1 / outside;
  const double sinBeta = std::sqrt(outside * outside - 1) * cosBeta;
  return cosAlpha * cosBeta - sinAlpha * sinBeta;
}

Vec3 farPoint(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3& p : points)
    sum = sum + toScaledSpace(p);
  const double size = length(sum);
  return size > 0 ? sum * (kFar / size) : Vec3{kFar, 0, 0};
}

} // namespace

Vec3 horizonOcclusionPoint(const Vec3& direction, const std::vector<Vec3>& points) {
  const Vec3 scaled = toScaledSpace(direction);
  const double size = length(scaled);
  if (!(size > 0))
    return farPoint(points);
  const Vec3 unit = scaled * (1 / size);
  double least = 1;
  for (const Vec3& p : points) {
    const double cosine = grazingCosine(unit, p);
    if (!(cosine >= least)) // also where it is not a number: a point in the earth's centre
      least = cosine;
  }
  least -= 4 * std::numeric_limits<double>::epsilon(); // rounding must not hide a point
  if (!(least > kLeastCosine))
    return farPoint(points);
  return unit * (1 / least);
}

} // namespace qmesh
