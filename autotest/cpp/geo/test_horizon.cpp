// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include "geo/bounding.h"
#include "geo/ellipsoid.h"
#include "random_vectors.h"

namespace qmesh {
namespace {

using test::RandomVectors;

Vec3 scaled(const Vec3& ecef) {
  return {ecef.x / wgs84::kSemiMajor, ecef.y / wgs84::kSemiMajor, ecef.z / wgs84::kSemiMinor};
}

/// The test of CesiumJS: does the unit sphere hide a point from a viewer (scaled space)?
bool isHidden(const Vec3& viewer, const Vec3& point) {
  const Vec3 view = point - viewer;
  const double limb = dot(viewer, viewer) - 1;
  const double along = -dot(view, viewer);
  return along > limb && along * along / dot(view, view) > limb;
}

/// Angle from a point at distance `magnitude` to where its line of sight grazes the unit sphere.
double limbAngle(double magnitude) {
  return magnitude > 1 ? std::atan(std::sqrt((magnitude - 1) * (magnitude + 1))) : 0;
}

/// A point at an angle from `from`, in the direction of `towards`.
Vec3 turned(const Vec3& from, const Vec3& towards, double angle, double magnitude) {
  const Vec3 unit = normalized(from);
  const Vec3 side = normalized(towards - unit * dot(towards, unit));
  return (unit * std::cos(angle) + side * std::sin(angle)) * magnitude;
}

struct Tile {
  std::vector<Vec3> points;
  Vec3 direction;
  Vec3 horizon;
};

Tile makeTile(RandomVectors& random, double sizeDegrees) {
  Tile tile;
  const double lon = random.real(-180, 180), lat = random.real(-90, 90 - sizeDegrees);
  const double base = random.real(0, 4000), relief = random.real(0, 4000);
  for (int i = 0; i < 30; ++i)
    tile.points.push_back(wgs84::toEcef(lon + random.real(0, sizeDegrees),
                                        lat + random.real(0, sizeDegrees),
                                        base + random.real(0, relief)));
  tile.direction = boundingSphere(tile.points).centre;
  tile.horizon = horizonOcclusionPoint(tile.direction, tile.points);
  return tile;
}

double altitude(RandomVectors& random) {
  return std::pow(10, random.real(-7, 2));
}

// A viewer placed so that he just sees one vertex must see the point, too.
TEST(HorizonPoint, IsSeenByWhoeverSeesAVertex) {
  RandomVectors random(6);
  for (int k = 0; k < 400; ++k) {
    const Tile tile = makeTile(random, std::pow(10, random.real(-3, 1.7)));
    for (const Vec3& vertex : tile.points) {
      const Vec3 p = scaled(vertex);
      for (int i = 0; i < 10; ++i) {
        const double magnitude = 1 + altitude(random);
        const double limit = limbAngle(magnitude) + limbAngle(length(p));
        const double angle = (limit - 1e-7) * (i < 5 ? 1 : random.real(0, 1));
        // Half of the viewers stand where the point is hidden first: beyond the vertex.
        const Vec3 towards =
            i % 2 ? random.direction() : p * (2 / length(p)) - normalized(scaled(tile.direction));
        EXPECT_FALSE(isHidden(turned(p, towards, angle, magnitude), tile.horizon));
      }
    }
  }
}

// And it is not farther out than needed: a viewer who just misses all vertices may miss it.
TEST(HorizonPoint, IsTight) {
  RandomVectors random(7);
  for (int k = 0; k < 200; ++k) {
    const Tile tile = makeTile(random, std::pow(10, random.real(-2, 1.5)));
    const Vec3 centre = normalized(scaled(tile.direction));
    double widest = 0;
    Vec3 extreme;
    for (const Vec3& vertex : tile.points) {
      const Vec3 p = scaled(vertex);
      const double angle = test::angleBetween(centre, p) + limbAngle(length(p));
      if (angle > widest) {
        widest = angle;
        extreme = p;
      }
    }
    const double magnitude = 1.5;
    const double angle = limbAngle(magnitude) + widest;
    EXPECT_TRUE(isHidden(turned(centre, extreme, angle + 1e-6, magnitude), tile.horizon));
    EXPECT_FALSE(isHidden(turned(centre, extreme, angle - 1e-6, magnitude), tile.horizon));
  }
}

TEST(HorizonPoint, OfOnePointIsThePoint) {
  const Vec3 summit = wgs84::toEcef(87, 28, 8848);
  EXPECT_LT(length(horizonOcclusionPoint(summit, {summit}) - scaled(summit)), 1e-12);
  const Vec3 trench = wgs84::toEcef(142, 11, -10900); // counts as on the ellipsoid
  EXPECT_NEAR(length(horizonOcclusionPoint(trench, {trench})), 1, 1e-12);
}

void expectNeverHidden(const Vec3& point) {
  EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
  RandomVectors random(8);
  for (int k = 0; k < 10000; ++k)
    EXPECT_FALSE(isHidden(random.direction() * (1 + altitude(random)), point));
}

TEST(HorizonPoint, OfHalfAGlobeIsNeverHidden) {
  for (const double west : {-180.0, 0.0}) {
    std::vector<Vec3> points;
    for (int lon = 0; lon <= 180; lon += 15)
      for (int lat = -90; lat <= 90; lat += 15)
        points.push_back(wgs84::toEcef(west + lon, lat, 100));
    expectNeverHidden(horizonOcclusionPoint(boundingSphere(points).centre, points));
    expectNeverHidden(horizonOcclusionPoint({0, 0, 0}, points));
  }
}

TEST(HorizonPoint, OfTheWholeGlobeIsNeverHidden) {
  const std::vector<Vec3> points{
      {6378137, 0, 0}, {-6378137, 0, 0}, {0, 0, 6356752}, {0, 0, -6356752}};
  expectNeverHidden(horizonOcclusionPoint({0, 0, 0}, points));
  expectNeverHidden(horizonOcclusionPoint({0, 1e-9, 0}, points));
  expectNeverHidden(horizonOcclusionPoint({1, 0, 0}, {{0, 0, 0}}));
}

} // namespace
} // namespace qmesh
