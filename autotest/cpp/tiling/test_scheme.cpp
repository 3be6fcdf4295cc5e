// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/scheme.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace qmesh {
namespace {

const Scheme kGeodetic(Profile::geodetic);
const Scheme kMercator(Profile::mercator);
constexpr double kLimit = 85.0511287798066;

TEST(Scheme, Roots) {
  EXPECT_EQ(kGeodetic.tilesX(0), 2u);
  EXPECT_EQ(kGeodetic.tilesY(0), 1u);
  EXPECT_EQ(kMercator.tilesX(0), 1u);
  EXPECT_EQ(kGeodetic.tilesX(kMaxZoom), 1u << 25);
  EXPECT_EQ(kMercator.tilesY(kMaxZoom), 1u << 24);
  EXPECT_STREQ(kGeodetic.crs(), "EPSG:4326");
  EXPECT_STREQ(kMercator.crs(), "EPSG:3857");
}

//   zoom 1, geodetic:  +---+---+---+---+ 90     rows count from the south
//                      |   |   |   |0,1|
//                      +---+---+---+---+ 0
//                   -180  -90  0  90  180
TEST(Scheme, Boxes) {
  const GeoBox box = kGeodetic.box({1, 3, 1});
  EXPECT_EQ(box.west, 90);
  EXPECT_EQ(box.south, 0);
  EXPECT_EQ(box.east, 180);
  EXPECT_EQ(box.north, 90);
  const GeoBox world = kMercator.box({0, 0, 0});
  EXPECT_EQ(world.west, -180);
  EXPECT_EQ(world.south, -kLimit);
  EXPECT_EQ(world.east, 180);
  EXPECT_EQ(world.north, kLimit);
  EXPECT_EQ(kMercator.box({1, 0, 1}).south, 0);
}

TEST(Scheme, NeighboursShareTheirEdge) {
  std::mt19937 random(11);
  for (const Scheme& scheme : {kGeodetic, kMercator})
    for (int zoom = 1; zoom <= kMaxZoom; ++zoom) {
      const std::uint32_t x = random() % (scheme.tilesX(zoom) - 1),
                          y = random() % (scheme.tilesY(zoom) - 1);
      EXPECT_EQ(scheme.box({zoom, x, y}).east, scheme.box({zoom, x + 1, y}).west);
      EXPECT_EQ(scheme.box({zoom, x, y}).north, scheme.box({zoom, x, y + 1}).south);
    }
}

// 360 k / 2^n - 180 needs few bits, so long double, with more of them, must agree exactly.
TEST(Scheme, GeodeticCoordinatesAreExact) {
  std::mt19937_64 random(12);
  for (int k = 0; k < 20000; ++k) {
    const std::int64_t whole = std::int64_t(1) << (random() % 36);
    const std::int64_t part = std::int64_t(random() % std::uint64_t(whole + 1));
    const long double fraction = (long double)part / (long double)whole;
    EXPECT_EQ((long double)kGeodetic.longitude(part, whole), -180 + 360 * fraction);
    EXPECT_EQ((long double)kGeodetic.latitude(part, whole), -90 + 180 * fraction);
    EXPECT_EQ(kGeodetic.fractionX(kGeodetic.longitude(part, whole)), double(fraction));
    EXPECT_EQ(kMercator.longitude(part, whole), kGeodetic.longitude(part, whole));
  }
}

TEST(Scheme, ScalingAFractionChangesNoBit) {
  std::mt19937_64 random(13);
  for (int k = 0; k < 20000; ++k) {
    const std::int64_t whole = 1 + std::int64_t(random() % 1000000);
    const std::int64_t part = std::int64_t(random() % std::uint64_t(whole + 1));
    const std::int64_t times = 2 + std::int64_t(random() % 1000);
    for (const Scheme& scheme : {kGeodetic, kMercator}) {
      EXPECT_EQ(scheme.longitude(part, whole), scheme.longitude(times * part, times * whole));
      EXPECT_EQ(scheme.latitude(part, whole), scheme.latitude(times * part, times * whole));
    }
  }
}

TEST(Scheme, MercatorLatitudesAreAntisymmetricAndRise) {
  for (const std::int64_t rows : {2LL, 256LL, 1LL << 14, 1LL << 34}) {
    EXPECT_EQ(kMercator.latitude(0, rows), -kLimit);
    EXPECT_EQ(kMercator.latitude(rows, rows), kLimit);
    EXPECT_EQ(kMercator.latitude(rows / 2, rows), 0);
    std::mt19937_64 random(14);
    for (int k = 0; k < 5000; ++k) {
      const std::int64_t j = std::int64_t(random() % std::uint64_t(rows));
      EXPECT_EQ(kMercator.latitude(j, rows), -kMercator.latitude(rows - j, rows));
      EXPECT_LT(kMercator.latitude(j, rows), kMercator.latitude(j + 1, rows));
    }
  }
}

// EPSG:3857 says y = R ln tan(pi/4 + lat/2), and the square reaches as far north as east.
TEST(Scheme, MercatorLatitudesAreThoseOfEpsg3857) {
  const long double pi = 3.14159265358979323846264338328L;
  for (int j = 0; j <= 1000; ++j) {
    const long double lat = kMercator.latitude(j, 1000) * pi / 180;
    EXPECT_NEAR(double(std::log(std::tan(pi / 4 + lat / 2)) / pi), 2 * j / 1000.0 - 1, 3e-15);
  }
}

TEST(Scheme, FractionsInvertCoordinates) {
  for (const Scheme& scheme : {kGeodetic, kMercator}) {
    for (int j = 0; j <= 1000; ++j)
      EXPECT_NEAR(scheme.fractionY(scheme.latitude(j, 1000)), j / 1000.0, 3e-15);
    EXPECT_EQ(scheme.fractionY(scheme.latitude(0, 1)), 0);
    EXPECT_EQ(scheme.fractionY(scheme.latitude(1, 1)), 1);
    EXPECT_EQ(scheme.fractionY(0), 0.5);
  }
  EXPECT_GT(kMercator.fractionY(90), 1); // not clamped, and a number
  EXPECT_TRUE(std::isfinite(kMercator.fractionY(90)));
}

TEST(Scheme, Sizes) {
  EXPECT_NEAR(kGeodetic.geometricError(0), 77067.34, 0.005);
  EXPECT_EQ(kMercator.geometricError(0), 2 * kGeodetic.geometricError(0));
  EXPECT_EQ(kGeodetic.geometricError(12), kGeodetic.geometricError(0) / 4096);
  EXPECT_NEAR(kGeodetic.tileMetres(0), 20037508.34, 0.01);
  EXPECT_NEAR(kMercator.tileMetres(3), 40075016.69 / 8, 0.01);
}

} // namespace
} // namespace qmesh
