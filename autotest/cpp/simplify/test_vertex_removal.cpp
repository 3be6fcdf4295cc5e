// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/vertex_removal.h"

#include <gtest/gtest.h>

#include "mesh/check.h"
#include "mesh/error_measure.h"
#include "simplified.h"
#include "simplify/node_mesh.h"

namespace qmesh {
namespace {

using namespace test;

const Place kPlace{Profile::mercator, 11, 352, 1300, 32};

/// All nodes as vertices but those of the border, which has its corners only.
struct Full {
  explicit Full(Terrain terrain)
      : patch(kPlace.lattice(), kPlace.id(), 1, 1, terrain, 5), tile(patch.tile()) {
    made.level = kPlace.level(50);
    made.frame.reset(tile, made.level);
    for (auto& places : made.border.places)
      places = {0, kQuantizedMax};
    nodes.reset(tile, made.frame, made.border, 32);
    heights.reset(tile, made.frame);
    for (int k = 0; k <= 32; ++k) {
      heights.mask(0, k);
      heights.mask(k, 0);
      heights.mask(32, k);
      heights.mask(k, 32);
    }
  }

  int removeAll(int keptCells, float tolerance) {
    VertexRemoval removal;
    int removed = 0;
    while (const int now = removal.run(nodes.triangulation(), heights, keptCells, tolerance))
      removed += now;
    nodes.write(made.tin);
    return removed;
  }

  TerrainPatch patch;
  HeightTile tile;
  Simplified made;
  NodeMesh nodes;
  NodeHeights heights;
};

TEST(VertexRemoval, LevelGroundNeedsNoVertex) {
  Full full(Terrain::flat);
  EXPECT_EQ(full.removeAll(32, 1), 31 * 31);
  EXPECT_EQ(checkTin(full.made.tin), "");
  EXPECT_EQ(full.made.tin.triangles.size(), 2u);
}

TEST(VertexRemoval, KeepsAGridOfNodes) {
  Full full(Terrain::flat);
  full.removeAll(8, 1);
  EXPECT_EQ(checkTin(full.made.tin), "");
  EXPECT_EQ(innerNodes(full.made).size(), 3u * 3u);
}

TEST(VertexRemoval, StaysWithinTheTolerance) {
  for (const Terrain terrain : {Terrain::fractal, Terrain::ridged}) {
    Full full(terrain);
    EXPECT_GT(full.removeAll(32, 100), 100);
    ASSERT_EQ(checkTin(full.made.tin), "");
    const Triangulation& mesh = full.nodes.triangulation();
    for (std::int32_t t = 0; t < mesh.triangleSlots(); ++t) {
      if (!mesh.alive(t))
        continue;
      const NodeError worst = full.heights.worst(
          mesh.cornerOf(t, 0).corner, mesh.cornerOf(t, 1).corner, mesh.cornerOf(t, 2).corner, 100);
      EXPECT_LT(worst.node, 0);
    }
  }
}

} // namespace
} // namespace qmesh
