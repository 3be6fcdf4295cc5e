// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// The four point-set methods: what they promise on any terrain, and drawn grids.
#include <cmath>

#include <gtest/gtest.h>

#include "../simplified.h"
#include "mesh/check.h"
#include "mesh/error_measure.h"

namespace qmesh {
namespace {

using namespace test;

constexpr const char* kMethods[] = {"grid", "random", "hierarchy", "wlop"};

Simplified run(const HeightTile& tile, const LevelParams& level, const std::string& method,
               const MethodOptions& options = {}) {
  return simplify(tile, level, *findSimplifier(method)->create(options));
}

void expectPromises(const Simplified& made, const HeightTile& tile) {
  ASSERT_EQ(checkTin(made.tin), "");
  const ErrorMeasure measure = measureError(tile, made.frame, made.tin);
  EXPECT_EQ(measure.max, made.tin.maxError);
  EXPECT_EQ(measure.sumSquared, made.tin.sumSquaredError);
  EXPECT_EQ(made.tin.reason, StopReason::parameter);
  EXPECT_EQ(borderPlaces(made), placesOf(made.border));
  const auto inner = innerNodes(made);
  const int step = tile.cells() / made.level.baseGrid;
  for (int j = step; j < tile.cells(); j += step) {
    for (int i = step; i < tile.cells(); i += step)
      EXPECT_TRUE(inner.count({i, j})) << i << " " << j;
  }
}

/// wlop takes seconds for a large tile; a few rounds say as much here.
MethodOptions quick() {
  MethodOptions options;
  options.iterations = 2;
  return options;
}

TEST(PointSets, KeepTheirPromisesOnEveryTerrainAndPlace) {
  unsigned seed = 1;
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      for (const double maxError : {300.0, 2.0, 0.0}) {
        for (const char* method : kMethods) {
          if (place.cells > 64 && (maxError == 0 || method == std::string("wlop")))
            continue;
          SCOPED_TRACE(testing::Message() << method << " " << place << " " << name(terrain)
                                          << " seed " << seed << " max error " << maxError);
          expectPromises(run(patch.tile(), place.level(maxError), method, quick()), patch.tile());
        }
      }
    }
  }
}

TEST(PointSets, ArePureFunctionsOfTheTile) {
  for (const char* method : kMethods) {
    const auto reused = findSimplifier(method)->create(quick());
    for (const Place& place : {places()[1], places()[5], places()[9]}) {
      for (const Terrain terrain : {Terrain::fractal, Terrain::steps, Terrain::cliff}) {
        SCOPED_TRACE(testing::Message() << method << " " << place << " " << name(terrain));
        const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 31);
        const LevelParams level = place.level(8);
        const Tin fresh = run(patch.tile(), level, method, quick()).tin;
        EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin));
        EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin));
      }
    }
  }
}

TEST(PointSets, AFlatTileOfEqualPointsWorks) {
  const Place place{Profile::geodetic, 15, 1, 1, 8};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (const char* method : kMethods) {
    SCOPED_TRACE(method);
    const Simplified made = run(patch.tile(), place.level(0.5), method);
    expectPromises(made, patch.tile());
    EXPECT_LE(made.tin.maxError, place.level(0.5).borderRounding());
  }
}

/// Flat, 9 x 9 nodes, no base grid.
struct Drawn {
  Place place;
  TerrainPatch patch{place.lattice(), place.id(), 1, 1, Terrain::flat, 1};
  LevelParams level = place.level(0.5);

  explicit Drawn(const Place& at) : place(at) { level.baseGrid = 1; }
  std::set<std::pair<int, int>> inner(const char* method, const MethodOptions& options) const {
    return innerNodes(run(patch.tile(), level, method, options));
  }
};

//  7  . . . . | . . .     Where the equator meets the prime meridian a grid in space is one in
//  5  . . . . | . . .     longitude and latitude: cubes of a bit more than four nodes hold the
//     --------+------     columns (and rows) 1-4 and 5-7. One node of each stays.
//  4  . . . . | . . .
//  1  . . . . | . . .
TEST(PointSets, GridKeepsOneNodeACube) {
  const Drawn drawn(Place{Profile::geodetic, 14, 16384, 8192, 8});
  MethodOptions options;
  options.cellSize = spec(std::to_string(drawn.place.lattice().scheme().tileMetres(14) / 8 * 4.2));
  std::set<std::pair<bool, bool>> cubes;
  const auto inner = drawn.inner("grid", options);
  for (const auto& [i, j] : inner)
    cubes.insert({i > 4, j > 4});
  EXPECT_EQ(inner.size(), 4u);
  EXPECT_EQ(cubes.size(), 4u);
}

//  At 60 degrees north the 7 x 7 inner nodes are twice as high as wide: the first cut is across,
//  and of both halves the node in the middle stays.
TEST(PointSets, HierarchyCutsTheLongAxisAndKeepsTheMiddle) {
  const Drawn drawn(Place{Profile::geodetic, 14, 16384, 13653, 8});
  MethodOptions options;
  options.clusterSize = spec("30");
  options.maxVariance = spec("0.3");
  const auto inner = drawn.inner("hierarchy", options);
  ASSERT_EQ(inner.size(), 2u);
  EXPECT_EQ(inner.begin()->first, 4);
  EXPECT_EQ(inner.rbegin()->first, 4);
  EXPECT_LE(inner.begin()->second, 3);
  EXPECT_GE(inner.rbegin()->second, 5);
}

/// The square of the smallest distance of two nodes, in cells.
int closest(const std::set<std::pair<int, int>>& nodes) {
  int best = 1 << 30;
  for (auto a = nodes.begin(); a != nodes.end(); ++a) {
    for (auto b = nodes.begin(); b != a; ++b) {
      const int di = a->first - b->first, dj = a->second - b->second;
      best = std::min(best, di * di + dj * dj);
    }
  }
  return best;
}

TEST(PointSets, WlopSpreadsWhatRandomLeavesInHeaps) {
  const Drawn drawn(Place{Profile::geodetic, 14, 16384, 8192, 64});
  MethodOptions options;
  options.randomPercent = spec("98");
  options.retainPercent = spec("2");
  EXPECT_LE(closest(drawn.inner("random", options)), 2);
  const auto spread = drawn.inner("wlop", options);
  EXPECT_GE(spread.size(), 75u);
  EXPECT_GE(closest(spread), 9);
}

TEST(PointSets, TheOrderOfATileIsItsOwn) {
  const Drawn here(Place{Profile::geodetic, 14, 100, 8192, 16});
  const Drawn there(Place{Profile::geodetic, 14, 101, 8192, 16});
  MethodOptions options;
  options.randomPercent = spec("80");
  EXPECT_NE(here.inner("random", options), there.inner("random", options));
}

TEST(PointSets, TheLargestTileTakesSeconds) {
  const Place place{Profile::geodetic, 10, 900, 300, 1024};
  LevelParams level = place.level(60);
  level.baseGrid = 8;
  for (const Terrain terrain : {Terrain::ridged, Terrain::steps}) {
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 21);
    SCOPED_TRACE(name(terrain));
    expectPromises(run(patch.tile(), level, "random"), patch.tile());
  }
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 21);
  for (const char* method : {"grid", "hierarchy"}) {
    SCOPED_TRACE(method);
    expectPromises(run(patch.tile(), level, method), patch.tile());
  }
}

TEST(PointSets, ExtremesOfEveryParameterWork) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 16};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 3);
  const auto inner = [&](const char* method, LevelSpec MethodOptions::*field, const char* value) {
    MethodOptions options;
    options.*field = spec(value);
    LevelParams level = place.level(5);
    level.baseGrid = 1;
    const Simplified made = run(patch.tile(), level, method, options);
    EXPECT_EQ(checkTin(made.tin), "") << method << " " << value;
    return innerNodes(made).size();
  };
  constexpr std::size_t kAll = 15 * 15;
  EXPECT_EQ(inner("grid", &MethodOptions::cellSize, "0.001"), kAll);
  EXPECT_EQ(inner("grid", &MethodOptions::cellSize, "1e9"), 1u);
  EXPECT_EQ(inner("random", &MethodOptions::randomPercent, "0"), kAll);
  EXPECT_EQ(inner("random", &MethodOptions::randomPercent, "100"), 0u);
  EXPECT_EQ(inner("random", &MethodOptions::randomPercent, "40"), kAll * 6 / 10);
  EXPECT_EQ(inner("hierarchy", &MethodOptions::clusterSize, "1"), kAll);
  EXPECT_EQ(inner("hierarchy", &MethodOptions::clusterSize, "1e9"), 1u);
  EXPECT_GT(inner("hierarchy", &MethodOptions::maxVariance, "0"), kAll / 4);
  EXPECT_EQ(inner("wlop", &MethodOptions::retainPercent, "0"), 0u);
  EXPECT_GT(inner("wlop", &MethodOptions::retainPercent, "100"), kAll / 2);
  EXPECT_GT(inner("wlop", &MethodOptions::radius, "0.001"), 0u);
  EXPECT_GT(inner("wlop", &MethodOptions::radius, "1e9"), 0u);
}

TEST(PointSets, AValueMayDifferPerZoom) {
  const Place place{Profile::geodetic, 4, 3, 9, 16};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 3);
  LevelParams level = place.level(2000);
  level.baseGrid = 1;
  MethodOptions options;
  options.randomPercent = spec("0-3:0,4-:100");
  EXPECT_TRUE(innerNodes(run(patch.tile(), level, "random", options)).empty());
  level.zoom = 3;
  EXPECT_EQ(innerNodes(run(patch.tile(), level, "random", options)).size(), 15u * 15u);
}

} // namespace
} // namespace qmesh
