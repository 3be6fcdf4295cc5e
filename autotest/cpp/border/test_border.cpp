// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "border/border.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../mesh/terrain.h"

namespace qmesh {
namespace {

using namespace test;

struct Made {
  TileFrame frame;
  Border border;
};

Made make(const HeightTile& tile, const LevelParams& level) {
  Made made;
  made.frame.reset(tile, level);
  makeBorder(tile, made.frame, level, made.border);
  return made;
}

/// Node (i, j) of the tile that is number k of an edge.
std::pair<int, int> nodeOf(Edge edge, int k, int cells) {
  switch (edge) {
  case kWest:
    return {0, k};
  case kSouth:
    return {k, 0};
  case kEast:
    return {cells, k};
  default:
    return {k, cells};
  }
}

bool alongRow(Edge edge) {
  return edge == kSouth || edge == kNorth;
}

/// The node number along an edge that a vertex stands for.
int nodeAt(const TileFrame& frame, Edge edge, std::uint16_t place) {
  return alongRow(edge) ? frame.nearestColumn(place) : frame.nearestRow(place);
}

/// The nodes of an edge's vertices.
std::vector<int> nodesOf(const Made& made, Edge edge) {
  std::vector<int> nodes;
  for (const std::uint16_t place : made.border[edge])
    nodes.push_back(nodeAt(made.frame, edge, place));
  return nodes;
}

constexpr Edge kEdges[] = {kWest, kSouth, kEast, kNorth};

TEST(MakeBorder, HasCornersAndBaseGridInOrder) {
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain));
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 11);
      const LevelParams level = place.level(20);
      const Made made = make(patch.tile(), level);
      for (const Edge edge : kEdges) {
        const std::vector<std::uint16_t>& places = made.border[edge];
        EXPECT_EQ(places.front(), 0);
        EXPECT_EQ(places.back(), kQuantizedMax);
        EXPECT_TRUE(std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) ==
                    places.end());
        const std::vector<int> nodes = nodesOf(made, edge);
        for (int k = 0; k <= place.cells; k += place.cells / level.baseGrid)
          EXPECT_TRUE(std::binary_search(nodes.begin(), nodes.end(), k));
      }
    }
  }
}

// P2 on the edges: the decoded polyline of the tile's own frame against the nodes' real positions,
// the vertices' own nodes included.
TEST(MakeBorder, KeepsEveryNodeWithinTheMaxError) {
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      for (const double maxError : {500.0, 30.0, 2.0, 0.1}) {
        SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " " << maxError);
        const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 12);
        const HeightTile tile = patch.tile();
        const double reachable = std::max(maxError, place.level(maxError).borderRounding());
        const Made made = make(tile, place.level(maxError));
        const TileFrame& frame = made.frame;
        for (const Edge edge : kEdges) {
          const auto height = [&](int k) {
            const auto [i, j] = nodeOf(edge, k, place.cells);
            return tile.at(i, j);
          };
          const auto vertexHeight = [&](std::uint16_t vertex) {
            return frame.decode(frame.quantizeBorder(height(nodeAt(frame, edge, vertex))));
          };
          const std::vector<std::uint16_t>& places = made.border[edge];
          std::size_t s = 0;
          for (int k = 0; k <= place.cells; ++k) {
            const double position = alongRow(edge) ? frame.nodeU(k) : frame.nodeV(k);
            while (s + 2 < places.size() && places[s + 1] <= position)
              ++s;
            const double ha = vertexHeight(places[s]), hb = vertexHeight(places[s + 1]);
            const double t = (position - places[s]) / (places[s + 1] - places[s]);
            ASSERT_LE(std::abs(ha + t * (hb - ha) - height(k)), reachable + frame.coarseStep() / 2)
                << "node " << k;
          }
        }
      }
    }
  }
}

TEST(MakeBorder, IsTheSameInBothTilesOfAnEdge) {
  using P = Profile;
  for (const Place& place :
       {Place{P::geodetic, 3, 15, 4, 64}, Place{P::geodetic, 0, 1, 0, 16},
        Place{P::mercator, 2, 3, 1, 128}, Place{P::geodetic, 11, 100, 2046, 32},
        Place{P::mercator, 14, 77, 12000, 256}, Place{P::mercator, 0, 0, 0, 64}}) {
    for (const Terrain terrain : kTerrains) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain));
      const bool twoRows = place.y + 1 < place.lattice().scheme().tilesY(place.zoom);
      const TerrainPatch patch(place.lattice(), place.id(), 2, twoRows ? 2 : 1, terrain, 5);
      const LevelParams level = place.level(9);
      const Made here = make(patch.tile(0, 0), level), east = make(patch.tile(1, 0), level);
      const auto sameHeights = [&](const Made& other, Edge edge) {
        if (here.frame.coarseStep() + other.frame.coarseStep() > 0)
          return;
        for (const int k : nodesOf(here, edge)) {
          const auto [i, j] = nodeOf(edge, k, place.cells);
          const float height = patch.tile(0, 0).at(i, j);
          EXPECT_NEAR(here.frame.decode(here.frame.quantizeBorder(height)),
                      other.frame.decode(other.frame.quantizeBorder(height)), 0.001);
        }
      };
      EXPECT_EQ(here.border[kEast], east.border[kWest]);
      sameHeights(east, kEast);
      for (int k = 0; k <= place.cells; ++k)
        ASSERT_EQ(here.frame.v(k), east.frame.v(k));
      if (twoRows) {
        const Made north = make(patch.tile(0, 1), level);
        EXPECT_EQ(here.border[kNorth], north.border[kSouth]);
        sameHeights(north, kNorth);
      }
    }
  }
}

TEST(MakeBorder, KeepsAPoleToTheBaseGrid) {
  const Place place{Profile::geodetic, 2, 3, 3, 32};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 5);
  for (int i = 0; i <= 32; ++i)
    patch.at(i, 32) = float(i * i); // not what a pole is, but the rule must not look
  LevelParams level = place.level(1);
  level.baseGrid = 4;
  const Made made = make(patch.tile(), level);
  EXPECT_EQ(nodesOf(made, kNorth), (std::vector<int>{0, 8, 16, 24, 32}));
  EXPECT_GT(made.border[kSouth].size(), 5u);
}

//  height  9            *            nodes 0..8, one peak: its two feet and the peak are
//          0  * * * * *   * * *      the vertices
TEST(MakeBorder, FindsAPeakAndItsFeet) {
  const Place place{Profile::geodetic, 12, 9, 9, 8};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int k = 0; k <= 8; ++k)
    patch.at(k, 0) = k == 5 ? 9 : 0;
  LevelParams level = place.level(1);
  level.baseGrid = 1;
  EXPECT_EQ(nodesOf(make(patch.tile(), level), kSouth), (std::vector<int>{0, 4, 5, 6, 8}));
}

TEST(MakeBorder, KeepsOnlyTheCornersOfAFlatTile) {
  const Place place{Profile::geodetic, 15, 9, 9, 256};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  const Border border = make(patch.tile(), place.level(0.3)).border;
  for (const std::vector<std::uint16_t>& places : border.places)
    EXPECT_EQ(places, (std::vector<std::uint16_t>{0, kQuantizedMax}));
}

//  30000 * * * * * *       a cliff between nodes 5 and 6, 4096 units wide: node 5 lies at
//  20479.375,
//      0             * * * its vertex at 20479, and the slope would put the node 2.7 m too low but
//                          for a second vertex at 20480; node 6 at 24575.25 is east of its vertex
TEST(MakeBorder, GivesANodeAtACliffBothItsPlaces) {
  const Place place{Profile::geodetic, 12, 9, 9, 8};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int k = 0; k <= 8; ++k)
    patch.at(k, 0) = k <= 5 ? 30000.0f : 0.0f;
  LevelParams level = place.level(1);
  level.baseGrid = 1;
  const std::vector<std::uint16_t> cliff{0, 20479, 20480, 24575, kQuantizedMax};
  EXPECT_EQ(make(patch.tile(), level).border[kSouth], cliff);
}

} // namespace
} // namespace qmesh
