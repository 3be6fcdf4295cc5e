// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/tile_frame.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "terrain.h"

namespace qmesh {
namespace {

using namespace test;

TEST(TileFrame, PutsNodesWhereTheyAre) {
  std::vector<Place> all = places();
  all.push_back({Profile::mercator, 0, 0, 0, 1024}); // the densest rows there are
  all.push_back({Profile::geodetic, 24, 1, 16777215, 1024});
  for (const Place& place : all) {
    SCOPED_TRACE(testing::Message() << place);
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 1);
    const HeightTile tile = patch.tile();
    TileFrame frame;
    frame.reset(tile, place.level(10));
    const int n = place.cells;
    EXPECT_EQ(frame.cells(), n);
    EXPECT_EQ(frame.nodeU(0), 0);
    EXPECT_EQ(frame.nodeV(0), 0);
    EXPECT_EQ(frame.nodeU(n), kQuantizedMax);
    EXPECT_EQ(frame.nodeV(n), kQuantizedMax);
    const GeoBox box = place.lattice().scheme().box(place.id());
    for (int k = 0; k <= n; ++k) {
      EXPECT_EQ(frame.u(k), std::lround(frame.nodeU(k)));
      EXPECT_EQ(frame.v(k), std::lround(frame.nodeV(k)));
      EXPECT_EQ(frame.nearestColumn(frame.u(k)), k);
      EXPECT_EQ(frame.nearestRow(frame.v(k)), k);
      const double latitude = box.south + (box.north - box.south) * frame.nodeV(k) / kQuantizedMax;
      EXPECT_NEAR(latitude, place.lattice().latitude(tile.row0() + k), 1e-9);
      if (k > 0) {
        EXPECT_GT(frame.u(k), frame.u(k - 1));
        EXPECT_GT(frame.v(k), frame.v(k - 1));
      }
    }
  }
}

TEST(TileFrame, NearestRowIsNearest) {
  const Place place{Profile::mercator, 0, 0, 0, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  TileFrame frame;
  frame.reset(patch.tile(), place.level(10));
  for (int v = 0; v <= kQuantizedMax; v += 7) {
    const int row = frame.nearestRow(std::uint16_t(v));
    for (int j = 0; j <= 64; ++j)
      EXPECT_LE(std::abs(frame.nodeV(row) - v), std::abs(frame.nodeV(j) - v));
  }
}

TEST(TileFrame, CoversItsHeightsTightlyAndRoundsToHalfAStep) {
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      for (const double maxError : {300.0, 4.0, 0.05, 0.0}) {
        SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " " << maxError);
        const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 7);
        const HeightTile tile = patch.tile();
        const LevelParams level = place.level(maxError);
        TileFrame frame;
        frame.reset(tile, level);
        const double step = (double(frame.maxHeight()) - frame.minHeight()) / kQuantizedMax;
        ASSERT_LT(frame.minHeight(), frame.maxHeight());
        float lowest = tile.at(0, 0), highest = lowest;
        bool covered = true, close = true;
        for (int j = 0; j <= place.cells; ++j) {
          for (int i = 0; i <= place.cells; ++i) {
            const float h = tile.at(i, j);
            lowest = std::min(lowest, h);
            highest = std::max(highest, h);
            covered = covered && h >= frame.minHeight() && h <= frame.maxHeight() + 0.001;
            close = close && std::abs(frame.decode(frame.quantize(h)) - h) <= step / 2 + 0.001;
          }
        }
        EXPECT_TRUE(covered);
        EXPECT_TRUE(close);
        const double lattice = frame.coarseStep() > 0 ? frame.coarseStep() : level.latticeStep;
        EXPECT_EQ(frame.coarseStep() > 0, highest - lowest > kQuantizedMax * level.latticeStep);
        EXPECT_LE(lowest - frame.minHeight(), lattice);
        // One division more would not reach the top, unless the finest step stopped it.
        const double range = highest + lattice - frame.minHeight();
        EXPECT_TRUE(frame.maxHeight() - frame.minHeight() <= 2 * range || step <= 1.0 / 2048)
            << frame.minHeight() << " " << frame.maxHeight();
      }
    }
  }
}

TEST(TileFrame, DecodesBorderHeightsToMultiplesOfTheStep) {
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain));
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 3);
      const HeightTile tile = patch.tile();
      const LevelParams level = place.level(6);
      TileFrame frame;
      frame.reset(tile, level);
      const double lattice = frame.coarseStep() > 0 ? frame.coarseStep() : level.latticeStep;
      const int n = place.cells;
      for (int k = 0; k <= n; ++k) {
        for (const float h : {tile.at(k, 0), tile.at(k, n), tile.at(0, k), tile.at(n, k)})
          ASSERT_NEAR(frame.decode(frame.quantizeBorder(h)), roundToLattice(h, lattice), 0.001);
      }
    }
  }
}

TEST(TileFrame, HoldsOutAgainstAbsurdHeights) {
  const Place place{Profile::geodetic, 5, 3, 3, 8};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (const float absurd : {20000.001f, -123456.789f, 1e9f, -3e30f}) {
    for (const bool everywhere : {false, true}) {
      for (int j = 0; j <= 8; ++j) {
        for (int i = 0; i <= 8; ++i)
          patch.at(i, j) = everywhere || (i == 3 && j == 4) ? absurd : 1.0f;
      }
      TileFrame frame;
      frame.reset(patch.tile(), place.level(0.001));
      EXPECT_LT(frame.minHeight(), frame.maxHeight());
      const double step = (double(frame.maxHeight()) - frame.minHeight()) / kQuantizedMax;
      EXPECT_NEAR(frame.decode(frame.quantize(absurd)), absurd, step + std::abs(absurd) * 1e-6);
    }
  }
}

TEST(RoundToLattice, RoundsHalvesUp) {
  EXPECT_EQ(roundToLattice(0.5, 1), 1);
  EXPECT_EQ(roundToLattice(-0.5, 1), 0);
  EXPECT_EQ(roundToLattice(0.374, 0.25), 0.25);
  EXPECT_EQ(roundToLattice(-2.6, 2), -2);
}

} // namespace
} // namespace qmesh
