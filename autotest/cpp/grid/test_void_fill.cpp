// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "grid/void_fill.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qmesh {
namespace {

constexpr int kCells = 8;

NodeWindow window(int zoom, const TileRange& tiles, float height) {
  NodeWindow w;
  w.reset(NodeLattice(Scheme(Profile::geodetic), zoom, kCells), tiles, kTileHalo);
  for (int b = 0; b < w.height(); ++b)
    std::fill_n(w.row(b), w.width(), height);
  return w;
}

TEST(VoidFill, ConstantTakesOnlyTheVoids) {
  NodeWindow w = window(3, {4, 4, 4, 4}, 5);
  w.row(3)[2] = NAN;
  fillVoids(w, -7);
  EXPECT_EQ(w.row(3)[2], -7);
  EXPECT_EQ(w.row(3)[3], 5);
}

TEST(VoidFill, TheTileTellsFilledNodes) {
  NodeWindow w = window(3, {4, 4, 4, 4}, 5);
  w.row(kTileHalo + 1)[kTileHalo + 2] = NAN;
  EXPECT_FALSE(w.tile({3, 4, 4}).isFilled(2, 1));
  fillVoids(w, 0);
  EXPECT_TRUE(w.tile({3, 4, 4}).isFilled(2, 1));
  EXPECT_FALSE(w.tile({3, 4, 4}).isFilled(1, 2));
  w.reset(w.lattice(), w.tiles(), kTileHalo);
  EXPECT_FALSE(w.tile({3, 4, 4}).isFilled(2, 1));
}

TEST(VoidFill, RowsBeyondThePoleStayVoid) {
  NodeWindow w;
  w.reset(NodeLattice(Scheme(Profile::geodetic), 0, kCells), {0, 0, 0, 0}, kTileHalo);
  fillVoids(w, 0);
  EXPECT_TRUE(std::isnan(w.row(0)[0]));
  EXPECT_EQ(w.row(kTileHalo)[0], 0);
  EXPECT_TRUE(std::isnan(w.row(w.height() - 1)[0]));
}

//   coarse:  10 . 20        fine row through them:   10 [15] 20
//   a void on a coarse node takes that node, one between two their mean, between four theirs
TEST(VoidFill, BridgesFromTheCoarserLevel) {
  NodeWindow coarse = window(2, {2, 2, 2, 2}, 0);
  for (int b = 0; b < coarse.height(); ++b) {
    for (int a = 0; a < coarse.width(); ++a) {
      coarse.row(b)[a] = float(10 * (coarse.column0() + a) + (coarse.row0() + b));
    }
  }
  NodeWindow fine = window(3, {4, 4, 5, 5}, NAN);
  fine.row(6)[6] = 1234;
  fillVoids(fine, coarse);
  for (int b = 0; b < fine.height(); ++b) {
    for (int a = 0; a < fine.width(); ++a) {
      const double expected =
          a == 6 && b == 6 ? 1234
                           : 5.0 * double(fine.column0() + a) + 0.5 * double(fine.row0() + b);
      EXPECT_NEAR(fine.row(b)[a], expected, 1e-4);
    }
  }
}

TEST(VoidFill, OutsideTheTilesOneHeight) {
  Availability tiles;
  tiles.add({3, 4, 4});
  NodeWindow w = window(3, {4, 4, 5, 4}, NAN);
  fillVoidsOutside(w, tiles, 9);
  const int edge = kTileHalo + kCells; // last column of tile 4, in the closed square
  EXPECT_TRUE(std::isnan(w.row(kTileHalo)[kTileHalo]));
  EXPECT_TRUE(std::isnan(w.row(kTileHalo)[edge]));
  EXPECT_EQ(w.row(kTileHalo)[edge + 1], 9);
  EXPECT_EQ(w.row(kTileHalo - 1)[kTileHalo], 9);
}

} // namespace
} // namespace qmesh
