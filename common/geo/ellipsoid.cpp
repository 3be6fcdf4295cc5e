// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "geo/ellipsoid.h"

#include <cmath>

namespace qmesh::wgs84 {
namespace {

constexpr double kSemiMajorSquared = kSemiMajor * kSemiMajor;
constexpr double kSemiMinorSquared = kSemiMinor * kSemiMinor;

/// Distance from the surface to the axis along the normal: the prime vertical radius, metres.
double primeVerticalRadius(double latDegrees) {
  const double s = std::sin(latDegrees * kRadiansPerDegree);
  const double c = std::cos(latDegrees * kRadiansPerDegree);
  return kSemiMajorSquared / std::sqrt(kSemiMajorSquared * c * c + kSemiMinorSquared * s * s);
}

} // namespace

Vec3 normal(double lonDegrees, double latDegrees) {
  const double lon = lonDegrees * kRadiansPerDegree;
  const double lat = latDegrees * kRadiansPerDegree;
  return {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
}

Vec3 toEcef(double lonDegrees, double latDegrees, double heightMetres) {
  const Vec3 n = normal(lonDegrees, latDegrees);
  const double radius = primeVerticalRadius(latDegrees);
  const double equatorial = radius + heightMetres;
  const double polar = radius * (kSemiMinorSquared / kSemiMajorSquared) + heightMetres;
  return {n.x * equatorial, n.y * equatorial, n.z * polar};
}

Geodetic fromEcef(const Vec3& position) {
  const double axis = std::hypot(position.x, position.y);
  const double flattened = kSemiMinor / kSemiMajor;
  const double squash = 1 - kSemiMinorSquared / kSemiMajorSquared;  // e^2
  const double stretch = kSemiMajorSquared / kSemiMinorSquared - 1; // e'^2
  double reduced = std::atan2(position.z, axis * flattened);
  double latitude = 0;
  for (int round = 0; round < 3; ++round) {
    const double s = std::sin(reduced), c = std::cos(reduced);
    latitude = std::atan2(position.z + stretch * kSemiMinor * s * s * s,
                          axis - squash * kSemiMajor * c * c * c);
    reduced = std::atan2(flattened * std::sin(latitude), std::cos(latitude));
  }
  const Vec3 foot = toEcef(0, latitude / kRadiansPerDegree, 0);
  const double up =
      std::cos(latitude) * (axis - foot.x) + std::sin(latitude) * (position.z - foot.z);
  return {std::atan2(position.y, position.x) / kRadiansPerDegree, latitude / kRadiansPerDegree, up};
}

double metresPerDegreeEast(double latDegrees) {
  if (std::abs(latDegrees) >= 90)
    return 0; // the cosine of 90 degrees in floating point is not quite that
  return primeVerticalRadius(latDegrees) * std::cos(latDegrees * kRadiansPerDegree) *
         kRadiansPerDegree;
}

double metresPerDegreeNorth(double latDegrees) {
  const double n = primeVerticalRadius(latDegrees) / kSemiMajor;
  return n * n * n * kSemiMinorSquared / kSemiMajor * kRadiansPerDegree;
}

Vec3 enuToEcef(double lonDegrees, double latDegrees, double east, double north, double up) {
  const double lon = lonDegrees * kRadiansPerDegree;
  const double lat = latDegrees * kRadiansPerDegree;
  const Vec3 eastward{-std::sin(lon), std::cos(lon), 0};
  const Vec3 northward{-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon),
                       std::cos(lat)};
  return eastward * east + northward * north + normal(lonDegrees, latDegrees) * up;
}

} // namespace qmesh::wgs84
