// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/node_heights.h"

#include <cmath>

#include <gtest/gtest.h>

#include "../mesh/terrain.h"

namespace qmesh {
namespace {

using namespace test;

/// The same search, node by node in plain loops.
NodeError plainWorst(const NodeHeights& heights, const HeightTile& tile, const TileFrame& frame,
                     const std::vector<bool>& masked, const SpanCorner (&t)[3], double tolerance) {
  NodeError found;
  double worst = tolerance;
  for (int j = 0; j <= frame.cells(); ++j) {
    for (int i = 0; i <= frame.cells(); ++i) {
      const double u = frame.nodeU(i), v = frame.nodeV(j);
      const auto area = [](double au, double av, double bu, double bv, double cu, double cv) {
        return (bu - au) * (cv - av) - (bv - av) * (cu - au);
      };
      const double whole = area(t[0].u, t[0].v, t[1].u, t[1].v, t[2].u, t[2].v);
      const double wa = area(u, v, t[1].u, t[1].v, t[2].u, t[2].v) / whole;
      const double wb = area(t[0].u, t[0].v, u, v, t[2].u, t[2].v) / whole;
      const double wc = 1 - wa - wb;
      if (wa <= 0 || wb <= 0 || wc <= 0 || masked[std::size_t(heights.index(i, j))])
        continue;
      const double plane = wa * t[0].height + wb * t[1].height + wc * t[2].height;
      const double error = std::abs(plane - (double(tile.at(i, j)) - frame.minHeight()));
      if (error > worst) {
        worst = error;
        found = {heights.index(i, j), float(error)};
      }
    }
  }
  return found;
}

TEST(NodeHeights, FindsTheWorstNodeOfATriangle) {
  std::mt19937 random(5);
  int found = 0;
  for (const Place& place : places()) {
    const int n = place.cells;
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, random());
    const HeightTile tile = patch.tile();
    TileFrame frame;
    frame.reset(tile, place.level(10));
    NodeHeights heights;
    heights.reset(tile, frame);
    std::vector<bool> masked(std::size_t(heights.index(n, n)) + 1, false);
    for (int k = 0; k < n; ++k) {
      const int i = int(random() % unsigned(n)), j = int(random() % unsigned(n));
      const std::int32_t node = heights.index(i, j);
      heights.mask(i, j);
      masked[std::size_t(node)] = true;
      EXPECT_TRUE(heights.isMasked(node));
    }
    for (int trial = 0; trial < 60; ++trial) {
      SpanCorner t[3];
      for (SpanCorner& corner : t) {
        const int j = int(random() % (n + 1));
        corner.u = frame.u(int(random() % (n + 1)));
        corner.v = frame.v(j);
        corner.column = spanColumn(corner.u, n);
        corner.height = random() % 2000;
        corner.row = j + (frame.nodeV(j) < corner.v ? 1 : 0);
      }
      const double area =
          double(t[1].u - t[0].u) * (t[2].v - t[0].v) - double(t[1].v - t[0].v) * (t[2].u - t[0].u);
      if (area == 0)
        continue;
      if (area < 0)
        std::swap(t[1], t[2]);
      const double tolerance = trial % 3 * 400;
      const NodeError expected = plainWorst(heights, tile, frame, masked, t, tolerance);
      const NodeError worst = heights.worst(t[0], t[1], t[2], float(tolerance));
      EXPECT_EQ(heights.areWithin(t[0], t[1], t[2], float(tolerance)), worst.node < 0) << place;
      if (std::abs(expected.error - tolerance) < 0.01)
        continue;
      // Nodes exactly on an edge may belong to the neighbour: those the plain loop leaves out.
      if (worst.error > expected.error + 0.01f)
        continue;
      EXPECT_NEAR(worst.error, expected.error, 0.01) << place;
      EXPECT_EQ(worst.node, expected.node) << place;
      found += worst.node >= 0 ? 1 : 0;
    }
  }
  EXPECT_GT(found, 200);
}

TEST(NodeHeights, TakesTheSmallestOfEqualNodesAndSkipsMaskedOnes) {
  const Place place{Profile::geodetic, 12, 5, 5, 64};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = 0; j <= 64; ++j) {
    for (int i = 0; i <= 64; ++i)
      patch.at(i, j) = (j == 20 || j == 40) && i % 10 == 5 ? 70 : 0;
  }
  const HeightTile tile = patch.tile();
  TileFrame frame;
  frame.reset(tile, place.level(10));
  NodeHeights heights;
  heights.reset(tile, frame);
  const SpanCorner a{0, 0, 0, 0, 0}, b{64, 0, kQuantizedMax, 0, 0},
      c{64, 0, kQuantizedMax, kQuantizedMax, 64};
  for (const std::pair<int, int>& expected :
       {std::pair<int, int>{25, 20}, {35, 20}, {45, 20}, {55, 20}, {45, 40}, {55, 40}}) {
    const NodeError worst = heights.worst(a, b, c, 10);
    EXPECT_EQ(heights.column(worst.node), expected.first);
    EXPECT_EQ(heights.row(worst.node), expected.second);
    EXPECT_EQ(worst.error, 70);
    heights.mask(expected.first, expected.second);
  }
  EXPECT_EQ(heights.worst(a, b, c, 10).node, -1);
  heights.unmask(35, 20);
  EXPECT_EQ(heights.worst(a, b, c, 10).node, heights.index(35, 20));
  EXPECT_EQ(heights.worst(a, b, c, 70).node, -1) << "not above the tolerance";
}

} // namespace
} // namespace qmesh
