// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "geo/bounding.h"

#include <gtest/gtest.h>

#include "geo/ellipsoid.h"
#include "random_vectors.h"

namespace qmesh {
namespace {

using test::RandomVectors;

double farthest(const std::vector<Vec3>& points, const Vec3& centre) {
  double distance = 0;
  for (const Vec3& p : points)
    distance = std::max(distance, std::hypot(p.x - centre.x, p.y - centre.y, p.z - centre.z));
  return distance;
}

/// Nearly the smallest sphere's radius: Badoiu & Clarkson 2003, steps of 1/k to the farthest point.
double smallRadius(const std::vector<Vec3>& points) {
  Vec3 centre = points.front();
  for (int k = 2; k < 1000; ++k) {
    const Vec3* far = &points.front();
    for (const Vec3& p : points)
      if (length(p - centre) > length(*far - centre))
        far = &p;
    centre = centre + (*far - centre) * (1.0 / k);
  }
  return farthest(points, centre);
}

TEST(BoundingSphere, HoldsEveryPointAndIsNotMuchTooLarge) {
  RandomVectors random(5);
  for (int k = 0; k < 300; ++k) {
    std::vector<Vec3> points;
    const double lon = random.real(-180, 180), lat = random.real(-85, 85);
    const double size = std::pow(10, random.real(-4, 1.3));
    const int count = 1 + int(random.real(0, 60));
    for (int i = 0; i < count; ++i)
      points.push_back(wgs84::toEcef(lon + random.real(0, size), lat + random.real(0, size) / 4,
                                     random.real(-100, 5000)));
    const Sphere sphere = boundingSphere(points);
    EXPECT_LE(farthest(points, sphere.centre), sphere.radius);
    EXPECT_LE(sphere.radius, 1.2 * smallRadius(points) + 1e-6);
  }
}

TEST(BoundingSphere, OfOnePointOrManyEqualOnes) {
  const Vec3 p{6378137, -3, 12};
  for (const std::vector<Vec3>& points : {std::vector<Vec3>{p}, std::vector<Vec3>(7, p)}) {
    const Sphere sphere = boundingSphere(points);
    EXPECT_EQ(sphere.radius, 0);
    EXPECT_EQ(length(sphere.centre - p), 0);
  }
}

} // namespace
} // namespace qmesh
