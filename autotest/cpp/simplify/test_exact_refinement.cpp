// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/exact_refinement.h"

#include <gtest/gtest.h>

#include "mesh/check.h"
#include "simplified.h"

namespace qmesh {
namespace {

using namespace test;

const Place kPlace{Profile::mercator, 11, 352, 1300, 64};

// The mesh of a coarse level, read back, refined to a finer one.
TEST(ExactRefinement, BringsAnyMeshWithinTheMaxError) {
  for (const Terrain terrain : {Terrain::fractal, Terrain::spikes, Terrain::steps}) {
    SCOPED_TRACE(name(terrain));
    const TerrainPatch patch(kPlace.lattice(), kPlace.id(), 1, 1, terrain, 9);
    const HeightTile tile = patch.tile();
    LevelParams level = kPlace.level(20);
    Simplified made = simplify(tile, level);
    level.maxError = 5000;
    ASSERT_TRUE(findSimplifier("greedy")
                    ->create({})
                    ->simplify(tile, made.frame, made.border, level, made.tin)
                    .ok());
    ASSERT_GT(measureError(tile, made.frame, made.tin).max, 20);

    NodeMesh nodes;
    nodes.reset(tile, made.frame, made.tin);
    ExactRefinement exact;
    exact.reset(tile, made.frame, 20);
    EXPECT_LE(exact.run(nodes, made.tin).max, 20);
    EXPECT_EQ(checkTin(made.tin), "");
    EXPECT_EQ(borderPlaces(made), placesOf(made.border));
  }
}

TEST(ExactRefinement, ReadsAMeshBackAsItIs) {
  const TerrainPatch patch(kPlace.lattice(), kPlace.id(), 1, 1, Terrain::fractal, 9);
  const HeightTile tile = patch.tile();
  Simplified made = simplify(tile, kPlace.level(20));
  made.tin.vertices[4].q += 100; // not the height of its node
  NodeMesh nodes;
  nodes.reset(tile, made.frame, made.tin);
  Tin back;
  nodes.write(back);
  back.maxError = made.tin.maxError;
  back.sumSquaredError = made.tin.sumSquaredError;
  EXPECT_TRUE(same(back, made.tin));
}

TEST(ExactRefinement, InsertsTheWorstNode) {
  TerrainPatch patch(kPlace.lattice(), kPlace.id(), 1, 1, Terrain::flat, 9);
  patch.at(20, 30) = 7;
  const HeightTile tile = patch.tile();
  Simplified made = simplify(tile, kPlace.level(50));
  ASSERT_TRUE(innerNodes(made).empty());
  NodeMesh nodes;
  nodes.reset(tile, made.frame, made.tin);
  ExactRefinement exact;
  exact.reset(tile, made.frame, 50);
  ASSERT_TRUE(exact.insertWorst(nodes));
  nodes.write(made.tin);
  EXPECT_EQ(innerNodes(made), (std::set<std::pair<int, int>>{{20, 30}}));
}

} // namespace
} // namespace qmesh
