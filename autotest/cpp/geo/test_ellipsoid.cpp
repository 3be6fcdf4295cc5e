// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "geo/ellipsoid.h"

#include <gtest/gtest.h>

#include "random_vectors.h"

namespace qmesh {
namespace {

using test::RandomVectors;

void expectNear(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Ellipsoid, AxesLieOnTheRadii) {
  expectNear(wgs84::toEcef(0, 0, 0), {6378137, 0, 0}, 1e-9);
  expectNear(wgs84::toEcef(90, 0, 10), {0, 6378147, 0}, 1e-8);
  expectNear(wgs84::toEcef(-180, 0, 0), {-6378137, 0, 0}, 1e-8);
  expectNear(wgs84::toEcef(33, 90, 0), {0, 0, 6356752.3142451793}, 1e-8);
  expectNear(wgs84::toEcef(33, -90, -5), {0, 0, -6356747.3142451793}, 1e-8);
}

// The surface is x^2/a^2 + y^2/a^2 + z^2/b^2 = 1 and its normal is the gradient of that; a height
// is a distance along the normal. These three determine the position, whatever the formula.
TEST(Ellipsoid, PositionFollowsFromTheSurfaceAndItsNormal) {
  RandomVectors random(1);
  const double a = wgs84::kSemiMajor, b = wgs84::kSemiMinor;
  for (int k = 0; k < 2000; ++k) {
    const double lon = random.real(-180, 180), lat = random.real(-90, 90);
    const double height = random.real(-11000, 9000);
    const Vec3 foot = wgs84::toEcef(lon, lat, 0);
    EXPECT_NEAR((foot.x * foot.x + foot.y * foot.y) / (a * a) + foot.z * foot.z / (b * b), 1,
                1e-14);
    const Vec3 gradient = normalized({foot.x / (a * a), foot.y / (a * a), foot.z / (b * b)});
    expectNear(gradient, wgs84::normal(lon, lat), 1e-14);
    expectNear(wgs84::toEcef(lon, lat, height), foot + gradient * height, 1e-8);
    EXPECT_NEAR(std::atan2(foot.y, foot.x) * 180 / wgs84::kPi, lon, 1e-12);
  }
}

TEST(Ellipsoid, GeodeticIsTheInverse) {
  for (const double latitude : {-90.0, -89.999, -45.0, 0.0, 1e-9, 12.5, 60.0, 89.0, 90.0}) {
    for (const double longitude : {-179.5, -90.0, 0.0, 33.0, 180.0}) {
      for (const double height : {-11000.0, 0.0, 8848.0, 5e6}) {
        const wgs84::Geodetic found = wgs84::fromEcef(wgs84::toEcef(longitude, latitude, height));
        const bool pole = std::abs(latitude) == 90;
        EXPECT_NEAR(found.latitudeDegrees, latitude, 1e-9);
        EXPECT_NEAR(pole ? longitude : found.longitudeDegrees, longitude, 1e-9);
        EXPECT_NEAR(found.heightMetres, height, 0.001) << latitude;
      }
    }
  }
}

TEST(Ellipsoid, MetresPerDegreeAreTheSpeedOfThePosition) {
  for (double lat = -89; lat <= 89; lat += 8.9) {
    const double d = 1e-4;
    const Vec3 east = wgs84::toEcef(20 + d, lat, 0) - wgs84::toEcef(20 - d, lat, 0);
    const Vec3 north = wgs84::toEcef(20, lat + d, 0) - wgs84::toEcef(20, lat - d, 0);
    EXPECT_NEAR(wgs84::metresPerDegreeEast(lat), length(east) / (2 * d), 1e-2);
    EXPECT_NEAR(wgs84::metresPerDegreeNorth(lat), length(north) / (2 * d), 1e-2);
  }
  EXPECT_EQ(wgs84::metresPerDegreeEast(90), 0);
  EXPECT_EQ(wgs84::metresPerDegreeEast(-90), 0);
}

TEST(Ellipsoid, EastNorthUpPointsWherePositionsMove) {
  RandomVectors random(2);
  for (int k = 0; k < 200; ++k) {
    const double lon = random.real(-180, 180), lat = random.real(-89, 89), d = 1e-4;
    const Vec3 east = wgs84::toEcef(lon + d, lat, 0) - wgs84::toEcef(lon - d, lat, 0);
    const Vec3 north = wgs84::toEcef(lon, lat + d, 0) - wgs84::toEcef(lon, lat - d, 0);
    expectNear(wgs84::enuToEcef(lon, lat, 1, 0, 0), normalized(east), 1e-6);
    expectNear(wgs84::enuToEcef(lon, lat, 0, 1, 0), normalized(north), 1e-6);
    expectNear(wgs84::enuToEcef(lon, lat, 0, 0, 1), wgs84::normal(lon, lat), 0);
    EXPECT_NEAR(length(wgs84::enuToEcef(lon, lat, 0.48, -0.6, 0.64)), 1, 1e-14);
  }
}

} // namespace
} // namespace qmesh
