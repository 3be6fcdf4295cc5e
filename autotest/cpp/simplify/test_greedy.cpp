// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>

#include <gtest/gtest.h>

#include "geo/ellipsoid.h"
#include "mesh/check.h"
#include "mesh/error_measure.h"
#include "simplified.h"

namespace qmesh {
namespace {

using namespace test;

constexpr double kMaxErrors[] = {700, 40, 3, 0.2, 0.001, 0};

void expectPromises(const Simplified& made, const HeightTile& tile) {
  ASSERT_EQ(checkTin(made.tin), "");
  const ErrorMeasure measure = measureError(tile, made.frame, made.tin);
  EXPECT_EQ(measure.max, made.tin.maxError);
  EXPECT_EQ(measure.sumSquared, made.tin.sumSquaredError);
  // Rounding of heights is the one excuse, and only where it is not far below the max error.
  if (made.tin.reason != StopReason::quantization) {
    EXPECT_LE(measure.max, made.level.maxError);
  } else {
    EXPECT_TRUE(made.level.maxError < 1.1 * made.level.borderRounding() ||
                made.level.maxError < made.frame.heightStep() || made.frame.coarseStep() > 0);
  }
  EXPECT_EQ(borderPlaces(made), placesOf(made.border));
}

TEST(Greedy, KeepsItsPromisesOnEveryTerrainAndPlace) {
  unsigned seed = 1;
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      for (const double maxError : kMaxErrors) {
        if (place.cells > 64 && maxError < 0.1)
          continue;
        for (const bool decimate : {false, true}) {
          SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " seed " << seed
                                          << " max error " << maxError << " decimate " << decimate);
          expectPromises(simplify(patch.tile(), place.level(maxError), decimate), patch.tile());
        }
      }
    }
  }
}

// Where rounding is far below the max error there is no excuse for missing it.
TEST(Greedy, ReachesTheMaxErrorOnOrdinaryTerrain) {
  for (const Place& place : places()) {
    for (const Terrain terrain :
         {Terrain::fractal, Terrain::ridged, Terrain::plane, Terrain::flat}) {
      for (const double maxError : {700.0, 40.0, 15.0}) {
        SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " " << maxError);
        const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 77);
        const Simplified made = simplify(patch.tile(), place.level(maxError));
        EXPECT_NE(made.tin.reason, StopReason::quantization);
        EXPECT_LE(made.tin.maxError, maxError);
      }
    }
  }
}

TEST(Greedy, KeepsTheBaseGrid) {
  const Place place{Profile::geodetic, 0, 0, 0, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  LevelParams level = place.level(20000);
  level.baseGrid = 16;
  const Simplified made = simplify(patch.tile(), level);
  EXPECT_EQ(made.tin.vertices.size(), 17u * 17u);
  const auto inner = innerNodes(made);
  for (int j = 4; j < 64; j += 4) {
    for (int i = 4; i < 64; i += 4)
      EXPECT_TRUE(inner.count({i, j}));
  }
}

TEST(Greedy, FlatTileIsTwoTriangles) {
  const Place place{Profile::geodetic, 15, 1, 1, 256};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  const Simplified made = simplify(patch.tile(), place.level(0.5));
  EXPECT_EQ(made.tin.triangles.size(), 2u);
  EXPECT_EQ(made.tin.reason, StopReason::maxError);
}

//  8  .  .  .  .  .  .  .  .  .     one peak of 50 m at (2, 5), one pit of 30 m at (6, 3), the rest
//  ...                              level: the worst node first, and of a cone in a plane nothing
//  5  .  . 50  .  .  .  .  .  .     but its tip and its feet is needed
//  3  .  .  .  .  .  . -30 .  .
//  0  .  .  .  .  .  .  .  .  .
TEST(Greedy, FindsPeakAndPitOfADrawnGrid) {
  const Place place{Profile::geodetic, 14, 9, 9, 8};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i)
      patch.at(i, j) = 0;
  }
  patch.at(2, 5) = 50;
  patch.at(6, 3) = -30;
  LevelParams level = place.level(29);
  level.baseGrid = 1;
  for (const bool decimate : {false, true}) {
    const auto inner = innerNodes(simplify(patch.tile(), level, decimate));
    EXPECT_TRUE(inner.count({2, 5}));
    EXPECT_TRUE(inner.count({6, 3}));
    for (const auto& [i, j] : inner) {
      const bool nearPeak = std::abs(i - 2) <= 2 && std::abs(j - 5) <= 2;
      const bool nearPit = std::abs(i - 6) <= 2 && std::abs(j - 3) <= 2;
      EXPECT_TRUE(nearPeak || nearPit) << i << " " << j;
    }
  }
  level.maxError = 51;
  EXPECT_TRUE(innerNodes(simplify(patch.tile(), level)).empty());
}

TEST(Greedy, AllNodesWhereEveryNodeIsNeeded) {
  const Place place{Profile::geodetic, 10, 9, 9, 16};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::extreme, 1);
  const Simplified made = simplify(patch.tile(), place.level(0));
  EXPECT_EQ(innerNodes(made).size(), 15u * 15u);
  EXPECT_EQ(made.tin.reason, StopReason::quantization);
}

TEST(Greedy, DecimationTakesAQuarterOfTheTrianglesAtLeast) {
  for (const Terrain terrain : {Terrain::fractal, Terrain::ridged}) {
    const Place place{Profile::geodetic, 12, 1411, 2828, 256};
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 4);
    const LevelParams level = place.level(10);
    const std::size_t plain = simplify(patch.tile(), level, false).tin.triangles.size();
    const std::size_t fewer = simplify(patch.tile(), level, true).tin.triangles.size();
    EXPECT_LT(fewer, plain * 3 / 4) << name(terrain) << " " << plain;
  }
}

TEST(Greedy, IsAPureFunctionOfTheTile) {
  const auto reused = findSimplifier("greedy")->create({});
  for (const Place& place : places()) {
    for (const Terrain terrain : {Terrain::fractal, Terrain::spikes}) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 31);
      const LevelParams level = place.level(8);
      const Tin fresh = simplify(patch.tile(), level).tin;
      EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin)) << place;
      EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin)) << place;
    }
  }
}

TEST(Greedy, WorksOnTheLargestTile) {
  for (const Place& place :
       {Place{Profile::geodetic, 10, 900, 300, 1024}, Place{Profile::mercator, 0, 0, 0, 1024}}) {
    SCOPED_TRACE(testing::Message() << place);
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 21);
    LevelParams level = place.level(60);
    level.baseGrid = 8;
    const Simplified made = simplify(patch.tile(), level);
    expectPromises(made, patch.tile());
    EXPECT_EQ(made.tin.reason, StopReason::maxError);
  }
}

TEST(Greedy, NeverMakes65536Vertices) {
  // All 255 x 255 inner nodes and 511 of the border's.
  const Place place{Profile::geodetic, 10, 9, 9, 256};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::extreme, 1);
  LevelParams level = place.level(0);
  level.baseGrid = 1;
  Simplified made;
  made.level = level;
  made.frame.reset(patch.tile(), level);
  for (std::vector<std::uint16_t>& nodes : made.border.places) {
    for (int k = 0; k <= 256; k += 2)
      nodes.push_back(made.frame.u(k));
  }
  // 4 * 128 border vertices, one taken away.
  made.border[kNorth].erase(made.border[kNorth].begin() + 7);
  const auto greedy = findSimplifier("greedy")->create({});
  ASSERT_TRUE(greedy->simplify(patch.tile(), made.frame, made.border, level, made.tin).ok());
  EXPECT_EQ(checkTin(made.tin), "");
  EXPECT_EQ(made.tin.vertices.size(), 65535u);
}

/// The largest distance of a node from the triangle below or above it, measured across the plane,
/// by the pages of a geometry book: every node against every triangle that holds it.
double largestDistance(const HeightTile& tile, const Simplified& made) {
  const GeoBox box = tile.lattice().scheme().box(tile.id());
  const double latitude = (box.south + box.north) / 2;
  const double east = (box.east - box.west) * wgs84::metresPerDegreeEast(latitude) / 32767;
  const double north = (box.north - box.south) * wgs84::metresPerDegreeNorth(latitude) / 32767;
  const auto point = [&](std::uint32_t k) {
    const TinVertex& v = made.tin.vertices[k];
    return Vec3{v.u * east, v.v * north, made.frame.decode(v.q)};
  };
  const auto turn = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  double largest = 0;
  for (const TinTriangle& t : made.tin.triangles) {
    const Vec3 a = point(t[0]), b = point(t[1]), c = point(t[2]), p = b - a, q = c - a;
    const Vec3 normal =
        normalized({p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x});
    for (int j = 0; j <= tile.cells(); ++j) {
      for (int i = 0; i <= tile.cells(); ++i) {
        const Vec3 node{made.frame.nodeU(i) * east, made.frame.nodeV(j) * north, tile.at(i, j)};
        const double grain = -1e-6;
        if (turn(a, b, node) > grain && turn(b, c, node) > grain && turn(c, a, node) > grain)
          largest = std::max(largest, std::abs(dot(normal, node - a)));
      }
    }
  }
  return largest;
}

TEST(Greedy, ThreeDimensionalErrorIsBoundedAcrossThePlanes) {
  const Place place{Profile::geodetic, 14, 5000, 6000, 32};
  MethodOptions options;
  options.errorType = ErrorType::distance3d;
  for (const bool decimate : {false, true}) {
    options.decimate = decimate;
    const auto method = findSimplifier("greedy")->create(options);
    for (const double maxError : {4.0, 20.0}) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 17);
      const LevelParams level = place.level(maxError);
      const Simplified height = simplify(patch.tile(), level, decimate);
      const Simplified across = simplify(patch.tile(), level, *method);
      ASSERT_EQ(checkTin(across.tin), "");
      EXPECT_EQ(borderPlaces(across), placesOf(across.border));
      EXPECT_LE(largestDistance(patch.tile(), across), maxError * (1 + 1e-9));
      EXPECT_LT(across.tin.triangles.size(), height.tin.triangles.size());
      EXPECT_GT(across.tin.maxError, maxError); // of the heights: slopes are steep here
      EXPECT_EQ(across.tin.reason, StopReason::parameter);
    }
  }
}

TEST(Greedy, TheInitialGridStaysAndLeavesTheBorderAlone) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 3);
  const LevelParams level = place.level(200);
  MethodOptions options;
  options.initGrid = spec("7"); // rounded up to 8
  const auto method = findSimplifier("greedy")->create(options);
  const Simplified made = simplify(patch.tile(), level, *method);
  expectPromises(made, patch.tile());
  const auto inner = innerNodes(made);
  for (int j = 8; j < 64; j += 8) {
    for (int i = 8; i < 64; i += 8)
      EXPECT_TRUE(inner.count({i, j})) << i << " " << j;
  }
  EXPECT_EQ(borderPlaces(made), borderPlaces(simplify(patch.tile(), level)));
}

// Under --border inherit: a free edge takes part in the insertion, a final one does not change.
TEST(Greedy, AddsNodesToFreeEdgesOnly) {
  EXPECT_TRUE(findSimplifier("greedy")->create({})->choosesBorder());
  unsigned seed = 40;
  for (const Place& place : places()) {
    if (place.zoom < 2)
      continue;
    for (const Terrain terrain : {Terrain::ridged, Terrain::spikes, Terrain::plane}) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain));
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      Simplified made;
      made.level = place.level(30);
      made.frame.reset(patch.tile(), made.level);
      makeBorder(patch.tile(), made.frame, made.level, made.border);
      for (const Edge edge : {kSouth, kEast}) {
        const bool pole = edge == kSouth && place.lattice().isPole(patch.tile().row0());
        made.border.isFree[std::size_t(edge)] = !pole;
        if (!pole)
          made.border[edge] = {0, kQuantizedMax};
      }
      const auto greedy = findSimplifier("greedy")->create({});
      ASSERT_TRUE(
          greedy->simplify(patch.tile(), made.frame, made.border, made.level, made.tin).ok());
      ASSERT_EQ(checkTin(made.tin), "");
      if (made.tin.reason != StopReason::quantization) {
        EXPECT_LE(made.tin.maxError, 30);
      }
      const auto given = placesOf(made.border);
      for (const auto& [u, v] : borderPlaces(made)) {
        const bool free = (v == 0 && made.border.isFree[kSouth]) ||
                          (u == kQuantizedMax && made.border.isFree[kEast]);
        EXPECT_TRUE(free || given.count({u, v})) << u << " " << v;
        if (free && !given.count({u, v})) {
          EXPECT_EQ(u, made.frame.u(made.frame.nearestColumn(std::uint16_t(u))));
          EXPECT_EQ(v, made.frame.v(made.frame.nearestRow(std::uint16_t(v))));
        }
      }
      for (const auto& vertex : given)
        EXPECT_TRUE(borderPlaces(made).count(vertex));
    }
  }
}

} // namespace
} // namespace qmesh
