// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/base_grid.h"

#include <gtest/gtest.h>

#include "terrain.h"

namespace qmesh {
namespace {

using namespace test;

struct Made {
  Made(const Place& place, double maxError)
      : level(place.level(maxError)), patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1) {
    frame.reset(patch.tile(), level);
    grid = BaseGrid(frame, level);
  }

  bool mayJoin(int i, int j, int k, int l) const { return grid.mayJoin(at(i, j), at(k, l)); }
  SpanCorner at(int i, int j) const {
    SpanCorner corner;
    corner.u = frame.u(i);
    corner.v = frame.v(j);
    return corner;
  }

  LevelParams level;
  TerrainPatch patch;
  TileFrame frame;
  BaseGrid grid;
};

TEST(CurvatureRules, PermitsTheDiagonalsOfItsCellsAndNoMore) {
  const Made made({Profile::geodetic, 0, 1, 0, 64}, 19267);
  ASSERT_EQ(made.level.baseGrid, 32);
  for (int k = 0; k < 64; k += 2) {
    EXPECT_TRUE(made.mayJoin(k, 0, k + 2, 2));
    EXPECT_TRUE(made.mayJoin(0, k + 2, 2, k));
  }
  EXPECT_FALSE(made.mayJoin(0, 0, 3, 0));
  EXPECT_FALSE(made.mayJoin(0, 0, 0, 3));
  EXPECT_FALSE(made.mayJoin(30, 30, 27, 29));
}

// At the equator a mercator tile's cells are more than twice as high in v as at its ends.
TEST(CurvatureRules, PermitsTheLargestCellOfAMercatorTile) {
  const Made made({Profile::mercator, 0, 0, 0, 64}, 38533);
  ASSERT_EQ(made.level.baseGrid, 64);
  for (int j = 0; j < 64; ++j)
    EXPECT_TRUE(made.mayJoin(10, j, 11, j + 1));
  EXPECT_FALSE(made.mayJoin(10, 31, 11, 33));
}

TEST(CurvatureRules, KeepsItsNodesAndThoseAdded) {
  Made made({Profile::geodetic, 7, 50, 90, 64}, 150);
  ASSERT_EQ(made.level.baseGrid, 4);
  EXPECT_TRUE(made.grid.isNode(16, 48));
  EXPECT_FALSE(made.grid.isNode(16, 40));
  made.grid.addNodes(8);
  EXPECT_TRUE(made.grid.isNode(16, 40));
  EXPECT_FALSE(made.mayJoin(0, 0, 17, 16));
  EXPECT_TRUE(made.mayJoin(0, 0, 16, 16));
  made.grid.addNodes(2);
  EXPECT_TRUE(made.grid.isNode(16, 40));
}

TEST(CurvatureRules, AsksForNothingWhereTheGroundIsFlat) {
  const Made made({Profile::geodetic, 13, 5000, 6000, 64}, 2);
  ASSERT_EQ(made.level.baseGrid, 1);
  EXPECT_TRUE(made.mayJoin(0, 0, 64, 64));
  EXPECT_FALSE(made.grid.isNode(32, 32));
  EXPECT_TRUE(BaseGrid().mayJoin(made.at(0, 0), made.at(64, 64)));
  EXPECT_FALSE(BaseGrid().isNode(32, 64));
}

} // namespace
} // namespace qmesh
