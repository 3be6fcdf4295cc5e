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

/// All nodes as vertices but those of the border, which has the base grid's only.
struct Full {
  explicit Full(Terrain terrain, int baseGrid = 1)
      : patch(kPlace.lattice(), kPlace.id(), 1, 1, terrain, 5), tile(patch.tile()) {
    made.level = kPlace.level(50);
    made.frame.reset(tile, made.level);
    made.level.baseGrid = baseGrid;
    for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
      for (int k = 0; k <= 32; k += 32 / baseGrid)
        made.border[edge].push_back(edge % 2 ? made.frame.u(k) : made.frame.v(k));
    }
    nodes.reset(tile, made.frame, made.border, 32);
    heights.reset(tile, made.frame);
    for (int k = 0; k <= 32; ++k) {
      heights.mask(0, k);
      heights.mask(k, 0);
      heights.mask(32, k);
      heights.mask(k, 32);
    }
  }

  int removeAll(float tolerance) {
    const BaseGrid grid(made.frame, made.level);
    VertexRemoval removal;
    int removed = 0;
    while (const int now = removal.run(nodes.triangulation(), heights, grid, tolerance))
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
  EXPECT_EQ(full.removeAll(1), 31 * 31);
  EXPECT_EQ(checkTin(full.made.tin), "");
  EXPECT_EQ(full.made.tin.triangles.size(), 2u);
}

TEST(VertexRemoval, KeepsTheBaseGridAndItsEdgesShort) {
  Full full(Terrain::flat, 4);
  EXPECT_GT(full.removeAll(1), 800);
  EXPECT_EQ(checkTin(full.made.tin), "");
  const BaseGrid grid(full.made.frame, full.made.level);
  const Triangulation& mesh = full.nodes.triangulation();
  for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
    const NodeVertex& vertex = mesh.vertices()[v];
    const bool alive = mesh.leaving(std::int32_t(v)) != Triangulation::kNone;
    EXPECT_TRUE(alive || !grid.isNode(vertex.i, vertex.j)) << vertex.i << " " << vertex.j;
  }
  for (std::int32_t e = 0; e < 3 * mesh.triangleSlots(); ++e) {
    if (mesh.alive(e / 3)) {
      EXPECT_TRUE(grid.mayJoin(mesh.vertex(mesh.origin(e)).corner,
                               mesh.vertex(mesh.destination(e)).corner));
    }
  }
}

TEST(VertexRemoval, StaysWithinTheTolerance) {
  for (const Terrain terrain : {Terrain::fractal, Terrain::ridged}) {
    Full full(terrain);
    EXPECT_GT(full.removeAll(100), 100);
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
