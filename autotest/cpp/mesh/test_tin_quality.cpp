// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/error_measure.h"
#include "mesh/tin_quality.h"
#include "terrain.h"

namespace qmesh {
namespace {

using namespace test;

constexpr double kMetresADegree = 6378137.0 * 3.14159265358979323846 / 180;

/// The square as two triangles, on the nodes' heights at its corners.
Tin twoTriangles(const HeightTile& tile, const TileFrame& frame) {
  const int n = tile.cells();
  const auto q = [&](int i, int j) { return frame.quantizeBorder(tile.at(i, j)); };
  Tin tin;
  tin.vertices = {
      {0, 0, q(0, 0)}, {32767, 0, q(n, 0)}, {32767, 32767, q(n, n)}, {0, 32767, q(0, n)}};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}};
  return tin;
}

TEST(TinQuality, AgreesWithTheErrorMeasure) {
  unsigned seed = 70;
  for (const Place& place : places()) {
    for (const Terrain terrain : {Terrain::fractal, Terrain::spikes, Terrain::steps}) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain));
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      TileFrame frame;
      frame.reset(patch.tile(), place.level(10));
      const Tin tin = twoTriangles(patch.tile(), frame);
      const TinQuality quality = measureQuality(patch.tile(), frame, tin);
      const ErrorMeasure measure = measureError(patch.tile(), frame, tin);
      const auto edge = std::uint64_t(place.cells + 1);
      EXPECT_EQ(quality.nodes, edge * edge); // each once
      EXPECT_NEAR(quality.height.max, measure.max, 1e-6 * measure.max + 1e-9);
      EXPECT_NEAR(quality.height.sumSquared, measure.sumSquared, 1e-6 * measure.sumSquared + 1e-6);
      EXPECT_LE(quality.height.sum / double(quality.nodes), quality.rms(quality.height) + 1e-9);
    }
  }
}

/// A mesh at 0 m under nodes that all lie on a plane through its south edge.
TEST(TinQuality, MeasuresAcrossAPlane) {
  const Place place{Profile::geodetic, 10, 1024, 512, 16}; // at the equator
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  const double size = kMetresADegree * 180 / 1024; // of the tile
  for (int j = 0; j <= 16; ++j) {
    for (int i = 0; i <= 16; ++i)
      patch.at(i, j) = float(size * j / 16); // 45 degrees
  }
  TileFrame frame;
  frame.reset(patch.tile(), place.level(1));
  Tin tin = twoTriangles(patch.tile(), frame);
  const TinQuality exact = measureQuality(patch.tile(), frame, tin);
  EXPECT_LT(exact.height.max, 1); // rounding
  // All nodes 100 m above the same slope: 100 m up are 100 / sqrt(2) m across.
  for (int j = 0; j <= 16; ++j) {
    for (int i = 0; i <= 16; ++i)
      patch.at(i, j) += 100;
  }
  const TinQuality raised = measureQuality(patch.tile(), frame, tin);
  EXPECT_NEAR(raised.height.max, 100, 1);
  EXPECT_NEAR(raised.distance.max, 100 / std::sqrt(2.0), 1);
  EXPECT_NEAR(raised.mean(raised.distance), 100 / std::sqrt(2.0), 1);
  EXPECT_NEAR(raised.rms(raised.distance), 100 / std::sqrt(2.0), 1);
}

TEST(TinQuality, MeasuresAngles) {
  const Place place{Profile::geodetic, 10, 1024, 512, 8};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  TileFrame frame;
  frame.reset(patch.tile(), place.level(1));
  const TinQuality quality = measureQuality(patch.tile(), frame, twoTriangles(patch.tile(), frame));
  EXPECT_NEAR(quality.minAngle, 45, 0.01); // a square at the equator
  EXPECT_NEAR(quality.meanAngle(), 45, 0.01);
  EXPECT_EQ(quality.triangles, 2u);
  // At 60 degrees north it is half as wide as high.
  const Place north{Profile::geodetic, 10, 1024, 853, 8};
  const TerrainPatch there(north.lattice(), north.id(), 1, 1, Terrain::flat, 1);
  frame.reset(there.tile(), north.level(1));
  EXPECT_NEAR(measureQuality(there.tile(), frame, twoTriangles(there.tile(), frame)).minAngle,
              std::atan(0.5) * 180 / 3.14159265358979323846, 0.2);
}

TEST(TinQuality, Adds) {
  TinQuality a, b;
  a.nodes = 2;
  a.height.add(1);
  a.height.add(3);
  b.nodes = 1;
  b.height.add(2);
  b.minAngle = 20;
  b.sumAngles = 20;
  b.triangles = 1;
  a.add(b);
  EXPECT_EQ(a.height.max, 3);
  EXPECT_EQ(a.mean(a.height), 2);
  EXPECT_NEAR(a.rms(a.height), std::sqrt(14.0 / 3), 1e-12);
  EXPECT_EQ(a.minAngle, 20);
  EXPECT_EQ(a.meanAngle(), 20);
}

} // namespace
} // namespace qmesh
