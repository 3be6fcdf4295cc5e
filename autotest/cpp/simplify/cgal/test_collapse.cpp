// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Method collapse beyond what test_every_method.cpp asks of all.
#include <cmath>
#include <functional>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "../simplified.h"
#include "mesh/check.h"
#include "mesh/error_measure.h"

namespace qmesh {
namespace {

using namespace test;

const Place kSmall{Profile::geodetic, 14, 9, 9, 8};
const Place kMedium{Profile::mercator, 12, 1000, 1500, 64};

using Change = std::function<void(MethodOptions&)>;

Simplified collapse(
    const HeightTile& tile, const LevelParams& level,
    const Change& change = [](MethodOptions&) {}) {
  MethodOptions options;
  options.name = "collapse";
  change(options);
  return simplify(tile, level, *findSimplifier("collapse")->create(options));
}

/// A tile of 9 x 9 nodes of one formula, with its level.
struct Drawn {
  Drawn(double maxError, const std::function<double(int, int)>& height)
      : patch(kSmall.lattice(), kSmall.id(), 1, 1, Terrain::flat, 1),
        level(kSmall.level(maxError)) {
    level.baseGrid = 1;
    for (int j = -kTileHalo; j <= 8 + kTileHalo; ++j) {
      for (int i = -kTileHalo; i <= 8 + kTileHalo; ++i)
        patch.at(i, j) = float(height(i, j));
    }
  }

  TerrainPatch patch;
  LevelParams level;
};

std::size_t edgesOf(const Tin& tin) {
  return tin.vertices.size() + tin.triangles.size() - 1; // Euler, one outside
}

using Nodes = std::set<std::pair<int, int>>;

/// The nodes of all vertices.
Nodes nodesOf(const Simplified& made) {
  Nodes nodes;
  for (const TinVertex& v : made.tin.vertices)
    nodes.insert({made.frame.nearestColumn(v.u), made.frame.nearestRow(v.v)});
  return nodes;
}

bool hasEdge(const Simplified& made, std::pair<int, int> a, std::pair<int, int> b) {
  const auto isAt = [&](std::uint32_t v, std::pair<int, int> node) {
    const TinVertex& vertex = made.tin.vertices[v];
    return made.frame.nearestColumn(vertex.u) == node.first &&
           made.frame.nearestRow(vertex.v) == node.second;
  };
  for (const TinTriangle& t : made.tin.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      if ((isAt(from, a) && isAt(to, b)) || (isAt(from, b) && isAt(to, a)))
        return true;
    }
  }
  return false;
}

const Change kVariants[] = {
    [](MethodOptions&) {},
    [](MethodOptions& o) { o.space = CollapseSpace::metric; },
    [](MethodOptions& o) { o.cost = CollapseCost::garlandHeckbert; },
    [](MethodOptions& o) {
      o.cost = CollapseCost::garlandHeckbert;
      o.space = CollapseSpace::metric;
    },
    [](MethodOptions& o) { o.shapeWeight = spec("1"); },
};

//  A plane needs its four corners.
TEST(Collapse, APlaneCollapsesToItsBorder) {
  const Drawn drawn(0.5, [](int i, int j) { return 4 * i - 8 * j; });
  for (const Change& variant : kVariants) {
    const Simplified made = collapse(drawn.patch.tile(), drawn.level, variant);
    EXPECT_EQ(nodesOf(made), (Nodes{{0, 0}, {8, 0}, {0, 8}, {8, 8}}));
    EXPECT_EQ(made.tin.triangles.size(), 2u);
    EXPECT_EQ(made.tin.reason, StopReason::maxError);
  }
}

//   0 10 20 30 40 30 20 10  0     A roof: in every row the same. Its ridge ends on the border,
//   where 0 10 20 30 40 30 20 10  0     the contract has vertices, and is an edge between them.
TEST(Collapse, ARoofKeepsItsRidge) {
  const Drawn drawn(0.5, [](int i, int) { return 40 - 10 * std::abs(i - 4); });
  for (const Change& variant : kVariants) {
    const Simplified made = collapse(drawn.patch.tile(), drawn.level, variant);
    EXPECT_EQ(nodesOf(made), (Nodes{{0, 0}, {4, 0}, {8, 0}, {0, 8}, {4, 8}, {8, 8}}));
    EXPECT_TRUE(hasEdge(made, {4, 0}, {4, 8}));
  }
}

//   0  0  0  0  0      A pyramid on the square: its tip and the corners (drawn at half its size).
//   0 20 20 20  0
//   0 20 40 20  0
TEST(Collapse, APyramidKeepsItsTip) {
  const Drawn drawn(
      0.5, [](int i, int j) { return 40 - 10 * std::max(std::abs(i - 4), std::abs(j - 4)); });
  for (const Change& variant : kVariants) {
    const Simplified made = collapse(drawn.patch.tile(), drawn.level, variant);
    EXPECT_EQ(nodesOf(made), (Nodes{{0, 0}, {8, 0}, {0, 8}, {8, 8}, {4, 4}}));
    EXPECT_EQ(made.tin.triangles.size(), 4u);
  }
}

//   0  0  0  0  0  0  0  0  0     One node of 50 m at (2, 5): with its feet at the max error's
//   0  0 50  0  0  0  0  0  0     distance it stays; a max error above it takes it away.
TEST(Collapse, ASpikeStaysWhereTheMaxErrorAsksForIt) {
  const auto spike = [](int i, int j) { return i == 2 && j == 5 ? 50 : 0; };
  const Drawn drawn(20, spike), coarse(51, spike);
  const Simplified made = collapse(drawn.patch.tile(), drawn.level);
  EXPECT_TRUE(nodesOf(made).count({2, 5}));
  EXPECT_LE(made.tin.maxError, 20);
  EXPECT_TRUE(innerNodes(collapse(coarse.patch.tile(), coarse.level)).empty());
}

TEST(Collapse, MeetsAnEdgeCountToWithinOne) {
  const TerrainPatch patch(kMedium.lattice(), kMedium.id(), 1, 1, Terrain::ridged, 3);
  const LevelParams level = kMedium.level(30);
  for (const Change& variant : kVariants) {
    for (const int count : {900, 1501, 4000, 12000}) {
      const Simplified made = collapse(patch.tile(), level, [&](MethodOptions& o) {
        variant(o);
        o.edgeCount = spec(std::to_string(count));
      });
      EXPECT_NEAR(double(edgesOf(made.tin)), count, 1);
      EXPECT_EQ(checkTin(made.tin), "");
      EXPECT_EQ(made.tin.reason, StopReason::parameter);
      EXPECT_EQ(borderPlaces(made), placesOf(made.border));
    }
  }
}

TEST(Collapse, MeetsAnEdgeRatio) {
  const TerrainPatch patch(kMedium.lattice(), kMedium.id(), 1, 1, Terrain::fractal, 3);
  const double full = 3 * 64 * 64 + 2 * 64;
  const Simplified made = collapse(patch.tile(), kMedium.level(30),
                                   [](MethodOptions& o) { o.edgeRatio = spec("0:1,12:0.25"); });
  EXPECT_NEAR(double(edgesOf(made.tin)), full / 4, 1);
}

// Fewer edges than border and fold-overs allow: what can be done.
TEST(Collapse, StopsWhereNothingCollapsesAnyMore) {
  for (const Terrain terrain : kTerrains) {
    SCOPED_TRACE(name(terrain));
    const TerrainPatch patch(kMedium.lattice(), kMedium.id(), 1, 1, terrain, 5);
    const Simplified made = collapse(patch.tile(), kMedium.level(60),
                                     [](MethodOptions& o) { o.edgeCount = spec("5"); });
    EXPECT_EQ(checkTin(made.tin), "");
    EXPECT_EQ(borderPlaces(made), placesOf(made.border));
    EXPECT_LT(innerNodes(made).size(), 60u);
  }
}

TEST(Collapse, MoreEdgesThanThereAreIsTheStartMesh) {
  const TerrainPatch patch(kSmall.lattice(), kSmall.id(), 1, 1, Terrain::fractal, 5);
  const Simplified made =
      collapse(patch.tile(), kSmall.level(1000), [](MethodOptions& o) { o.edgeRatio = spec("1"); });
  EXPECT_EQ(innerNodes(made).size(), 49u);
}

TEST(Collapse, AZoomWithoutAValueIsAnError) {
  const TerrainPatch patch(kSmall.lattice(), kSmall.id(), 1, 1, Terrain::fractal, 5);
  MethodOptions options;
  options.edgeCount = spec("0-3:500");
  const LevelParams level = kSmall.level(10);
  TileFrame frame;
  frame.reset(patch.tile(), level);
  Border border;
  makeBorder(patch.tile(), frame, level, border);
  Tin tin;
  const Status status = findSimplifier("collapse")
                            ->create(options)
                            ->simplify(patch.tile(), frame, border, level, tin);
  EXPECT_EQ(status.code(), Code::usage);
}

void expectPromises(const Simplified& made, const HeightTile& tile) {
  ASSERT_EQ(checkTin(made.tin), "");
  EXPECT_EQ(borderPlaces(made), placesOf(made.border));
  EXPECT_EQ(measureError(tile, made.frame, made.tin).max, made.tin.maxError);
  if (made.tin.reason != StopReason::quantization) {
    EXPECT_LE(made.tin.maxError, made.level.maxError);
  } else {
    EXPECT_TRUE(made.level.maxError < 1.1 * made.level.borderRounding() ||
                made.level.maxError < made.frame.heightStep() || made.frame.coarseStep() > 0);
  }
}

TEST(Collapse, KeepsItsPromisesWithEveryCostAndSpace) {
  unsigned seed = 70;
  for (const Place& place : places()) {
    if (place.cells > 64)
      continue;
    for (const Terrain terrain : kTerrains) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      for (const double maxError : {700.0, 15.0, 0.2, 0.0}) {
        const Change& variant = kVariants[seed % std::size(kVariants)];
        SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " seed " << seed
                                        << " max error " << maxError);
        expectPromises(collapse(patch.tile(), place.level(maxError), variant), patch.tile());
      }
    }
  }
}

TEST(Collapse, ReachesTheMaxErrorOnOrdinaryTerrain) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 128};
  for (const Terrain terrain : {Terrain::fractal, Terrain::ridged}) {
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 4);
    const LevelParams level = place.level(20);
    const Simplified made = collapse(patch.tile(), level), greedy = simplify(patch.tile(), level);
    EXPECT_EQ(made.tin.reason, StopReason::maxError);
    EXPECT_LE(made.tin.maxError, 20);
    EXPECT_LT(made.tin.triangles.size(), greedy.tin.triangles.size());
    EXPECT_GT(made.tin.triangles.size(), greedy.tin.triangles.size() / 2);
  }
}

TEST(Collapse, KeepsTheBaseGrid) {
  const Place place{Profile::geodetic, 0, 0, 0, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 1);
  LevelParams level = place.level(20000);
  level.baseGrid = 16;
  const auto inner = innerNodes(collapse(patch.tile(), level));
  for (int j = 4; j < 64; j += 4) {
    for (int i = 4; i < 64; i += 4)
      EXPECT_TRUE(inner.count({i, j})) << i << " " << j;
  }
}

// --border inherit: the free edges of a plane lose all nodes but their ends.
TEST(Collapse, FreeEdgesCollapseAlongThemselves) {
  const Drawn drawn(0.5, [](int i, int j) { return 4 * i - 8 * j; });
  TileFrame frame;
  frame.reset(drawn.patch.tile(), drawn.level);
  Border border;
  for (auto& places : border.places)
    places = {0, kQuantizedMax};
  border.isFree = {true, true, true, true};
  Tin tin;
  const auto method = findSimplifier("collapse")->create({});
  EXPECT_TRUE(method->choosesBorder());
  ASSERT_TRUE(method->simplify(drawn.patch.tile(), frame, border, drawn.level, tin).ok());
  EXPECT_EQ(checkTin(tin), "");
  EXPECT_EQ(tin.triangles.size(), 2u);
}

TEST(Collapse, VerticesOfFreeEdgesAreNodesAtTheirPlaces) {
  const TerrainPatch patch(kMedium.lattice(), kMedium.id(), 1, 1, Terrain::fractal, 21);
  const HeightTile tile = patch.tile();
  const LevelParams level = kMedium.level(20);
  TileFrame frame;
  frame.reset(tile, level);
  Border border;
  makeBorder(tile, frame, level, border);
  border.isFree = {false, true, true, false};
  border[kSouth] = border[kEast] = {0, kQuantizedMax};
  Tin tin;
  ASSERT_TRUE(
      findSimplifier("collapse")->create({})->simplify(tile, frame, border, level, tin).ok());
  ASSERT_EQ(checkTin(tin), "");
  EXPECT_LE(tin.maxError, 20);
  std::size_t south = 0;
  for (const TinVertex& v : tin.vertices) {
    if (v.v != 0)
      continue;
    ++south;
    const int i = frame.nearestColumn(v.u);
    EXPECT_EQ(v.u, frame.u(i));
    EXPECT_EQ(v.q, frame.quantizeBorder(tile.at(i, 0)));
  }
  EXPECT_GT(south, 2u);
  EXPECT_LT(south, 40u);
}

// P3: whatever lies on the heap, and beside another thread.
TEST(Collapse, IsAPureFunctionOfTheTile) {
  const Place place{Profile::geodetic, 12, 1000, 1500, 32};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  const TerrainPatch rough(place.lattice(), place.id(), 1, 1, Terrain::checkerboard, 1);
  for (const TerrainPatch* each : {&patch, &rough}) { // costs are equal everywhere
    for (const Change& variant : kVariants) {
      const auto run = [&](Tin& tin) {
        tin = collapse(each->tile(), place.level(30), [&](MethodOptions& o) {
                variant(o);
                o.edgeCount = spec("500");
              }).tin;
      };
      Tin first, second, third;
      run(first);
      std::vector<std::unique_ptr<char[]>> clutter;
      for (std::size_t k = 1; k < 3000; ++k) {
        clutter.push_back(std::make_unique<char[]>(k * 37 % 900 + 1));
        if (k % 3 == 0)
          clutter[k / 2].reset();
      }
      std::thread other([&] { run(second); });
      run(third);
      other.join();
      EXPECT_TRUE(same(first, second));
      EXPECT_TRUE(same(first, third));
    }
  }
}

} // namespace
} // namespace qmesh
