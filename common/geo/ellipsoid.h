// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "geo/vec3.h"

namespace qmesh::wgs84 {

inline constexpr double kSemiMajor = 6378137.0;          ///< metres
inline constexpr double kSemiMinor = 6356752.3142451793; ///< metres, as in CesiumJS
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kRadiansPerDegree = kPi / 180.0;

/// The outward normal of the ellipsoid at a geodetic position, unit length.
Vec3 normal(double lonDegrees, double latDegrees);

/// The ECEF position of a geodetic one; `heightMetres` is above the ellipsoid.
Vec3 toEcef(double lonDegrees, double latDegrees, double heightMetres);

/// A position on or above the ellipsoid.
struct Geodetic {
  double longitudeDegrees = 0; ///< -180..180
  double latitudeDegrees = 0;
  double heightMetres = 0; ///< above the ellipsoid
};

/// The geodetic position of an ECEF one at least 1000 km from the earth's centre; the inverse of
/// toEcef() to a millimetre (Bowring, "Transformation from spatial to geographical coordinates",
/// 1976, in three rounds).
Geodetic fromEcef(const Vec3& position);

/// Metres that one degree of longitude spans at a latitude (prime vertical radius * cos).
double metresPerDegreeEast(double latDegrees);

/// Metres that one degree of latitude spans at a latitude (meridian radius).
double metresPerDegreeNorth(double latDegrees);

/// Turns a direction given in the local east-north-up frame at a position into ECEF.
Vec3 enuToEcef(double lonDegrees, double latDegrees, double east, double north, double up);

} // namespace qmesh::wgs84
