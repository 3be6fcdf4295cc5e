// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/scheme.h"

#include <cmath>

#include "geo/ellipsoid.h"

namespace qmesh {
namespace {

/// Latitude where the mercator square ends, as everybody writes it.
constexpr double kMercatorLimit = 85.0511287798066;

/// The Gudermannian: latitude of y, in units of the square's half height, 0..1.
double mercatorLatitude(double y) {
  if (y >= 1)
    return kMercatorLimit;
  return std::atan(std::sinh(wgs84::kPi * y)) / wgs84::kRadiansPerDegree;
}

/// The inverse.
double mercatorY(double latDegrees) {
  if (latDegrees == kMercatorLimit)
    return 1;
  return std::asinh(std::tan(latDegrees * wgs84::kRadiansPerDegree)) / wgs84::kPi;
}

/// The fraction, moved to the middle of the whole: -1..1. One division of two whole numbers, so the
/// result is the same however the fraction is scaled.
double fromMiddle(std::int64_t numerator, std::int64_t denominator) {
  return double(2 * numerator - denominator) / double(denominator);
}

} // namespace

std::string tileName(TileId tile) {
  return std::to_string(tile.z) + "/" + std::to_string(tile.x) + "/" + std::to_string(tile.y);
}

GeoBox Scheme::box(TileId tile) const {
  const std::int64_t columns = tilesX(tile.z);
  const std::int64_t rows = tilesY(tile.z);
  return {longitude(tile.x, columns), latitude(tile.y, rows),
          longitude(std::int64_t(tile.x) + 1, columns), latitude(std::int64_t(tile.y) + 1, rows)};
}

double Scheme::longitude(std::int64_t numerator, std::int64_t denominator) const {
  return double(360 * numerator - 180 * denominator) / double(denominator);
}

double Scheme::latitude(std::int64_t numerator, std::int64_t denominator) const {
  if (profile_ == Profile::geodetic)
    return double(180 * numerator - 90 * denominator) / double(denominator);
  const double y = fromMiddle(numerator, denominator);
  return y < 0 ? -mercatorLatitude(-y) : mercatorLatitude(y);
}

double Scheme::fractionX(double lonDegrees) const {
  return (lonDegrees + 180) / 360;
}

double Scheme::fractionY(double latDegrees) const {
  if (profile_ == Profile::geodetic)
    return (latDegrees + 90) / 180;
  const double y = latDegrees < 0 ? -mercatorY(-latDegrees) : mercatorY(latDegrees);
  return (y + 1) / 2;
}

double Scheme::geometricError(int zoom) const {
  return std::ldexp(wgs84::kSemiMajor * 2 * wgs84::kPi * 0.25 / (65.0 * tilesX(0)), -zoom);
}

double Scheme::tileMetres(int zoom) const {
  return std::ldexp(wgs84::kSemiMajor * 2 * wgs84::kPi / tilesX(0), -zoom);
}

const char* Scheme::crs() const {
  return profile_ == Profile::geodetic ? "EPSG:4326" : "EPSG:3857";
}

} // namespace qmesh
