// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>

#include <gtest/gtest.h>

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

TEST(Greedy, KeepsTheCurvatureGrid) {
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

} // namespace
} // namespace qmesh
