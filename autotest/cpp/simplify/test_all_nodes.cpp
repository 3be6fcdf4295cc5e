// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include "mesh/check.h"
#include "mesh/error_measure.h"
#include "simplified.h"

namespace qmesh {
namespace {

using namespace test;

TEST(AllNodes, KeepsEveryNodeInAValidMesh) {
  for (const Place& place : places()) {
    SCOPED_TRACE(testing::Message() << place);
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 6);
    const Simplified made = simplify(patch.tile(), place.level(10), true, "delaunay");
    const auto count = std::size_t(place.cells + 1);
    EXPECT_EQ(checkTin(made.tin), "");
    EXPECT_EQ(made.tin.vertices.size(), count * count);
    EXPECT_EQ(made.tin.triangles.size(), 2 * (count - 1) * (count - 1));
    EXPECT_EQ(made.tin.reason, StopReason::allNodes);
    EXPECT_EQ(made.tin.maxError, measureError(patch.tile(), made.frame, made.tin).max);
  }
}

TEST(AllNodes, CutsCellsAlongTheFlatterDiagonal) {
  const Place place{Profile::geodetic, 14, 9, 9, 8};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i)
      patch.at(i, j) = float(i + j >= 8 ? 100 : 0); // a cliff along the falling diagonals
  }
  const Simplified made = simplify(patch.tile(), place.level(10), true, "delaunay");
  // No triangle has its long edge across the cliff.
  for (const TinTriangle& t : made.tin.triangles) {
    int high = 0;
    for (const std::uint32_t v : t)
      high += made.tin.vertices[v].q > made.frame.quantize(50) ? 1 : 0;
    const TinVertex& longFrom = made.tin.vertices[t[0]];
    const TinVertex& longTo = made.tin.vertices[t[2]];
    if (longFrom.u < longTo.u && longFrom.v < longTo.v) {
      EXPECT_TRUE(high == 0 || high == 3);
    }
  }
}

TEST(Registry, FindsMethodsByName) {
  ASSERT_NE(findSimplifier("greedy"), nullptr);
  ASSERT_NE(findSimplifier("delaunay"), nullptr);
  EXPECT_EQ(findSimplifier("Greedy"), nullptr);
  for (const SimplifierInfo& info : simplifiers()) {
    EXPECT_EQ(findSimplifier(info.name), &info);
    EXPECT_NE(info.create({}), nullptr);
  }
}

} // namespace
} // namespace qmesh
