// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// What the collapse begins with and what it is judged by.
#include <gtest/gtest.h>

#include "../simplified.h"
#include "mesh/check.h"
#include "simplify/cgal/mesh_thinning.h"
#include "simplify/cgal/star_judge.h"

namespace qmesh {
namespace {

using namespace test;

const Place kPlace{Profile::mercator, 12, 1000, 1500, 16};

Tin tinOf(const CollapseMesh& mesh) {
  Tin tin;
  for (const CollapseVertex& v : mesh.vertices)
    tin.vertices.push_back({std::uint16_t(v.corner.u), std::uint16_t(v.corner.v), v.q});
  tin.triangles = mesh.triangles;
  return tin;
}

struct Start {
  Start(Terrain terrain, double maxError, unsigned freeBits = 0)
      : patch(kPlace.lattice(), kPlace.id(), 1, 1, terrain, 7), tile(patch.tile()) {
    made.level = kPlace.level(maxError);
    made.frame.reset(tile, made.level);
    makeBorder(tile, made.frame, made.level, made.border);
    for (std::size_t edge = 0; edge < 4; ++edge)
      made.border.isFree[edge] = (freeBits >> edge & 1) != 0;
    makeStartMesh(tile, made.frame, made.border, made.level, mesh);
    made.tin = tinOf(mesh);
  }

  TerrainPatch patch;
  HeightTile tile;
  Simplified made;
  CollapseMesh mesh;
};

TEST(StartMesh, HasAllInnerNodesAndThePrescribedBorder) {
  for (const Terrain terrain : kTerrains) {
    SCOPED_TRACE(name(terrain));
    const Start start(terrain, 30);
    EXPECT_EQ(checkTin(start.made.tin), "");
    EXPECT_EQ(borderPlaces(start.made), placesOf(start.made.border));
    EXPECT_EQ(innerNodes(start.made).size(), 15u * 15u);
  }
}

TEST(StartMesh, HasAllNodesOfAFreeEdge) {
  const Start start(Terrain::fractal, 30, 1u << kSouth);
  EXPECT_EQ(checkTin(start.made.tin), "");
  std::size_t south = 0;
  for (const TinVertex& v : start.made.tin.vertices)
    south += v.v == 0;
  EXPECT_EQ(south, 17u);
}

// At a cliff the rounded place of a node lies on the slope: it gets the other one as well.
TEST(StartMesh, AFreeEdgeIsWithinTheMaxErrorAtCliffs) {
  const Start start(Terrain::extreme, 2.5, 15);
  EXPECT_EQ(checkTin(start.made.tin), "");
  std::size_t south = 0;
  for (const TinVertex& v : start.made.tin.vertices)
    south += v.v == 0;
  EXPECT_GT(south, 17u);
}

TEST(MeshThinning, LeavesAValidMeshWithinTheTolerance) {
  for (const Terrain terrain : {Terrain::fractal, Terrain::plane, Terrain::flat}) {
    Start start(terrain, 60);
    MeshThinning().run(start.tile, start.made.frame, BaseGrid(), 20, start.mesh);
    Simplified thinned = start.made;
    thinned.tin = tinOf(start.mesh);
    EXPECT_EQ(checkTin(thinned.tin), "");
    EXPECT_EQ(borderPlaces(thinned), placesOf(start.made.border));
    EXPECT_LT(innerNodes(thinned).size(), terrain == Terrain::fractal ? 200u : 12u);
  }
}

/// The triangles around two neighbouring inner nodes.
std::vector<TinTriangle> starOf(const CollapseMesh& mesh, std::uint32_t a, std::uint32_t b) {
  std::vector<TinTriangle> star;
  for (const TinTriangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      if (v == a || v == b) {
        star.push_back(t);
        break;
      }
    }
  }
  return star;
}

TEST(StarJudge, RefusesFoldsAndErrors) {
  const Start start(Terrain::flat, 30);
  const std::uint32_t a = 7 * 15 + 6, b = a + 1; // nodes (7, 8) and (8, 8)
  const std::vector<TinTriangle> star = starOf(start.mesh, a, b);
  VertexRounding rounding;
  rounding.reset(start.tile, start.made.frame);
  const TileFrame& frame = start.made.frame;
  const double middle = (frame.u(7) + frame.u(8)) / 2.0, row = frame.v(8),
               ground = start.mesh.vertices[a].corner.height;
  StarJudge judge;
  judge.reset(start.tile, frame, start.made.border, {}, start.mesh, 1.0);
  EXPECT_TRUE(judge.accepts(a, b, rounding.inner(middle, row, ground), star));
  EXPECT_TRUE(judge.accepts(a, b, rounding.inner(middle, row, ground + 0.9), star));
  EXPECT_FALSE(judge.accepts(a, b, rounding.inner(middle, row, ground + 3), star));
  EXPECT_FALSE(judge.accepts(a, b, rounding.inner(frame.u(10), row, ground), star));
  judge.reset(start.tile, frame, start.made.border, {}, start.mesh, std::nullopt);
  EXPECT_TRUE(judge.accepts(a, b, rounding.inner(middle, row, ground + 3), star));
  EXPECT_FALSE(judge.accepts(a, b, rounding.inner(frame.u(10), row, ground), star));
  // Onto the line between two others: a triangle without area.
  EXPECT_FALSE(judge.accepts(a, b, rounding.inner(frame.u(6), row, ground), star));
}

TEST(VertexRounding, AtANodeItIsTheNode) {
  const Start start(Terrain::fractal, 30);
  VertexRounding rounding;
  rounding.reset(start.tile, start.made.frame);
  const TileFrame& frame = start.made.frame;
  EXPECT_EQ(rounding.inner(frame.u(5), frame.v(6), 0).q, frame.quantize(start.tile.at(5, 6)));
  const CollapseVertex between = rounding.inner(frame.u(5) + 40.4, frame.v(6), 12.5);
  EXPECT_EQ(between.corner.u, frame.u(5) + 40);
  EXPECT_NEAR(between.corner.height, 12.5, frame.heightStep() / 2);
}

TEST(VertexRounding, StaysInTheSquare) {
  const Start start(Terrain::fractal, 30);
  VertexRounding rounding;
  rounding.reset(start.tile, start.made.frame);
  const CollapseVertex far = rounding.inner(-1e30, 1e30, 1e30);
  EXPECT_EQ(far.corner.u, 1);
  EXPECT_EQ(far.corner.v, kQuantizedMax - 1);
}

} // namespace
} // namespace qmesh
