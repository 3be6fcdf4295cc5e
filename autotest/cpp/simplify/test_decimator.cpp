// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/decimator.h"

#include <random>

#include <gtest/gtest.h>

#include "../mesh/terrain.h"

namespace qmesh {
namespace {

using namespace test;

/// A tile with a Delaunay mesh over random nodes of it.
class RandomMesh {
 public:
  RandomMesh(const Place& place, Terrain terrain, unsigned seed)
      : patch_(place.lattice(), place.id(), 1, 1, terrain, seed), tile(patch_.tile()) {
    frame.reset(tile, place.level(5));
    heights.reset(tile, frame);
    const int n = place.cells;
    mesh.reset({vertex(0, 0), vertex(n, 0), vertex(n, n), vertex(0, n)});
    for (int k = 0; k <= n; ++k) {
      for (const auto& [i, j] : {std::pair<int, int>{k, 0}, {k, n}, {0, k}, {n, k}})
        heights.mask(i, j);
    }
    std::mt19937 random(seed);
    for (int k = 0; k < 4 * n; ++k) {
      const int i = int(random() % unsigned(n)), j = int(random() % unsigned(n));
      if (heights.isMasked(heights.index(i, j)))
        continue;
      mesh.insert(vertex(i, j), 0);
      heights.mask(i, j);
    }
  }

  /// The largest error of an unmasked node, metres above the tolerance or -1.
  float worst(float tolerance) const {
    float error = -1;
    for (std::int32_t t = 0; t < mesh.triangleSlots(); ++t) {
      if (!mesh.alive(t))
        continue;
      const NodeError found = heights.worst(mesh.cornerOf(t, 0).corner, mesh.cornerOf(t, 1).corner,
                                            mesh.cornerOf(t, 2).corner, tolerance);
      error = found.node >= 0 ? std::max(error, found.error) : error;
    }
    return error;
  }

  int aliveVertices() const {
    int count = 0;
    for (std::size_t v = 0; v < mesh.vertices().size(); ++v)
      count += mesh.leaving(std::int32_t(v)) != Triangulation::kNone ? 1 : 0;
    return count;
  }

  /// Every triangle counter-clockwise, their areas the square's.
  void expectValid() const {
    std::int64_t area = 0;
    for (std::int32_t t = 0; t < mesh.triangleSlots(); ++t) {
      if (!mesh.alive(t))
        continue;
      const std::int64_t own = doubledArea(mesh.cornerOf(t, 0).corner, mesh.cornerOf(t, 1).corner,
                                           mesh.cornerOf(t, 2).corner);
      ASSERT_GT(own, 0);
      area += own;
    }
    EXPECT_EQ(area, std::int64_t(2) * kQuantizedMax * kQuantizedMax);
  }

 private:
  NodeVertex vertex(int i, int j) const {
    NodeVertex made;
    made.i = std::uint16_t(i);
    made.j = std::uint16_t(j);
    made.q = frame.quantize(tile.at(i, j));
    made.corner = {spanColumn(frame.u(i), frame.cells()), frame.decode(made.q) - frame.minHeight(),
                   frame.u(i), frame.v(j), j + (frame.nodeV(j) < frame.v(j) ? 1 : 0)};
    return made;
  }

  TerrainPatch patch_;

 public:
  HeightTile tile;
  TileFrame frame;
  NodeHeights heights;
  Triangulation mesh;
};

TEST(Decimator, NeverMakesAnErrorAboveTheTolerance) {
  Decimator decimator;
  int removed = 0;
  unsigned seed = 0;
  for (const Place& place : places()) {
    for (const Terrain terrain : {Terrain::fractal, Terrain::ridged, Terrain::plane}) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " seed " << ++seed);
      RandomMesh random(place, terrain, seed);
      // Just above the error that the mesh has, so that all of it is due to the decimation.
      const float tolerance = std::max(random.worst(0), 0.5f) * 1.001f;
      const int before = random.aliveVertices();
      const int gone = decimator.run(random.mesh, random.heights, {}, tolerance);
      removed += gone;
      EXPECT_EQ(random.aliveVertices(), before - gone);
      EXPECT_EQ(random.worst(tolerance), -1);
      random.expectValid();
    }
  }
  EXPECT_GT(removed, 1000);
}

TEST(Decimator, KeepsTheGridItIsToldTo) {
  const Place place{Profile::geodetic, 10, 3, 300, 64};
  RandomMesh random(place, Terrain::flat, 3);
  BaseGrid grid(random.frame, place.level(1e6));
  grid.addNodes(4);
  EXPECT_GT(Decimator().run(random.mesh, random.heights, grid, 1), 100);
  for (std::size_t v = 0; v < random.mesh.vertices().size(); ++v) {
    const NodeVertex& vertex = random.mesh.vertices()[v];
    const bool kept = vertex.i % 16 == 0 && vertex.j % 16 == 0;
    const bool alive = random.mesh.leaving(std::int32_t(v)) != Triangulation::kNone;
    EXPECT_TRUE(alive || !kept) << vertex.i << " " << vertex.j;
  }
  random.expectValid();
}

TEST(Decimator, LeavesWhatIsNeeded) {
  const Place place{Profile::geodetic, 10, 3, 300, 64};
  RandomMesh random(place, Terrain::extreme, 3);
  const int before = random.aliveVertices();
  EXPECT_LT(Decimator().run(random.mesh, random.heights, {}, 1), before / 100);
}

TEST(Decimator, RemovesAnyVertexWhereHeightsDoNotCount) {
  const Place place{Profile::geodetic, 10, 3, 300, 16};
  RandomMesh random(place, Terrain::extreme, 3);
  Decimator decimator;
  for (int left = random.aliveVertices(); left > 4; --left) {
    ASSERT_TRUE(decimator.removeAny(random.mesh, random.heights));
    EXPECT_EQ(random.aliveVertices(), left - 1);
    random.expectValid();
  }
  EXPECT_FALSE(decimator.removeAny(random.mesh, random.heights));
}

} // namespace
} // namespace qmesh
