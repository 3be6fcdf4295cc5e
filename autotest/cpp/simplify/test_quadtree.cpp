// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/text.h"
#include "geo/ellipsoid.h"
#include "mesh/check.h"
#include "mesh/error_measure.h"
#include "seam.h"
#include "simplify/quadtree/curvature.h"
#include "simplify/quadtree/leaf_templates.h"
#include "simplify/quadtree/observer.h"
#include "simplify/quadtree/quadtree_mesh.h"

namespace qmesh {
namespace {

using namespace test;

using Nodes = std::set<std::pair<int, int>>;

/// Divides by a curvature; by the level's max error where none is given.
MethodOptions curvatureOptions(const std::string& curvature) {
  MethodOptions options;
  options.curvature = spec(curvature);
  options.maxError = spec(curvature.empty() ? "1" : ""); // what it says is in the level
  return options;
}

Simplified quadtree(const HeightTile& tile, const LevelParams& level,
                    const MethodOptions& options = curvatureOptions("")) {
  const auto method = findSimplifier("quadtree")->create(options);
  return simplify(tile, level, *method);
}

/// All leaves that touch a side of another one.
void expectRestricted(const RestrictedQuadtree& tree) {
  const int n = tree.cells();
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int size = tree.leafSize(i, j);
      if (i + 1 < n) {
        EXPECT_LE(tree.leafSize(i + 1, j), 2 * size);
        EXPECT_LE(size, 2 * tree.leafSize(i + 1, j));
      }
      if (j + 1 < n) {
        EXPECT_LE(tree.leafSize(i, j + 1), 2 * size);
        EXPECT_LE(size, 2 * tree.leafSize(i, j + 1));
      }
    }
  }
}

TEST(RestrictedQuadtree, NeighboursDifferByOneLevelHoweverItIsDivided) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    RestrictedQuadtree tree;
    const int n = 8 << random() % 4;
    tree.reset(n, 1 << random() % 3);
    for (int k = 0; k < 40; ++k) {
      const int i = int(random() % unsigned(n)), j = int(random() % unsigned(n));
      if (tree.leafSize(i, j) > 1)
        tree.divide(i, j);
    }
    expectRestricted(tree);
    int area = 0;
    tree.forEachLeaf([&](const QuadCell& leaf) {
      area += leaf.size * leaf.size;
      EXPECT_EQ(leaf.i % leaf.size, 0);
      EXPECT_EQ(leaf.j % leaf.size, 0);
      EXPECT_EQ(tree.leafSize(leaf.i, leaf.j), leaf.size);
    });
    EXPECT_EQ(area, n * n);
  }
}

//  . . . . . . . .      dividing the corner leaf of 8 cells down to one cell takes its neighbours
//  . . . . . . . .      along: 4 beside 2 beside 1
TEST(RestrictedQuadtree, ADrawnCornerTakesItsNeighboursAlong) {
  RestrictedQuadtree tree;
  tree.reset(8, 1);
  for (int k = 0; k < 3; ++k)
    tree.divide(0, 0);
  EXPECT_EQ(tree.leafSize(0, 0), 1);
  EXPECT_EQ(tree.leafSize(2, 0), 2);
  EXPECT_EQ(tree.leafSize(4, 0), 4);
  EXPECT_EQ(tree.leafSize(7, 7), 4);
  tree.divide(2, 0); // its eastern neighbour of 4 must go first
  EXPECT_EQ(tree.leafSize(3, 1), 1);
  EXPECT_EQ(tree.leafSize(4, 0), 2);
}

// Every template covers its leaf with triangles that have all its vertices and no T-vertex.
TEST(LeafTemplates, CoverTheLeafWithoutTVertices) {
  static constexpr int u[kLeafPlaces] = {0, 1, 2, 2, 2, 1, 0, 0};
  static constexpr int v[kLeafPlaces] = {0, 0, 0, 1, 2, 2, 2, 1};
  for (int middles = 0; middles < 16; ++middles) {
    for (const bool rising : {false, true}) {
      int area = 0;
      std::set<std::pair<int, int>> edges;
      for (const auto& [a, b, c] : leafTemplate(middles, rising)) {
        const int doubled = (u[b] - u[a]) * (v[c] - v[a]) - (v[b] - v[a]) * (u[c] - u[a]);
        EXPECT_GT(doubled, 0) << middles;
        area += doubled;
        for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
          EXPECT_TRUE(edges.insert(edge).second);
      }
      EXPECT_EQ(area, 8);
      // The outline, counter-clockwise, place by place: each piece is an edge, once.
      std::vector<int> outline;
      for (int place = 0; place < kLeafPlaces; ++place) {
        if (place % 2 == 0 || middles >> (place / 2) & 1)
          outline.push_back(place);
      }
      std::size_t single = 0;
      for (const auto& [a, b] : edges)
        single += edges.count({b, a}) ? 0 : 1;
      EXPECT_EQ(single, outline.size());
      for (std::size_t k = 0; k < outline.size(); ++k)
        EXPECT_TRUE(edges.count({outline[k], outline[(k + 1) % outline.size()]})) << middles;
    }
  }
}

// The formula of the paper, written out with metres per node computed here.
TEST(Curvature, IsTheFormulaOfThePaper) {
  for (const Place& place :
       {Place{Profile::geodetic, 9, 513, 300, 16}, Place{Profile::mercator, 11, 352, 1300, 32}}) {
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 7);
    const HeightTile tile = patch.tile();
    Curvature curvature;
    curvature.reset(tile);
    const auto latitude = [&](int j) { return place.lattice().latitude(tile.row0() + j); };
    const auto gx = [&](int i, int j) {
      const double cell =
          360.0 / double(place.lattice().columns()) * wgs84::metresPerDegreeEast(latitude(j));
      return (double(tile.at(i + 1, j)) - tile.at(i - 1, j)) / (2 * cell);
    };
    const auto gy = [&](int i, int j) {
      const double both =
          (latitude(j + 1) - latitude(j - 1)) * wgs84::metresPerDegreeNorth(latitude(j));
      return (double(tile.at(i, j + 1)) - tile.at(i, j - 1)) / both;
    };
    double sum = 0;
    for (int j = 0; j <= place.cells; ++j) {
      for (int i = 0; i <= place.cells; ++i) {
        const double expected = std::sqrt(
            std::pow(gx(i + 1, j) - gx(i - 1, j), 2) + std::pow(gy(i + 1, j) - gy(i - 1, j), 2) +
            std::pow(gx(i, j + 1) - gx(i, j - 1), 2) + std::pow(gy(i, j + 1) - gy(i, j - 1), 2));
        EXPECT_NEAR(curvature.kappa(i, j), expected, 1e-9 * (1 + expected));
        sum += expected;
      }
    }
    CumulatedCurvature cumulated;
    cumulated.reset(tile, curvature);
    EXPECT_NEAR(cumulated.ofCell(0, 0, place.cells), sum, 1e-9 * sum);
    double part = 0;
    for (int j = 4; j <= 8; ++j) {
      for (int i = 8; i <= 12; ++i)
        part += curvature.kappa(i, j);
    }
    EXPECT_NEAR(cumulated.ofCell(8, 4, 4), part, 1e-9 * sum);
  }
}

//  8  o  .  .  .  o     one peak at (6, 6) of 16 x 16 cells: its leaf of four cells, from (4, 4) to
//  7  .  o  o  o  .     (8, 8), is halved to two cells, where the peak is a vertex and the middles
//  of 6  o  o  P  o  o     the sides around are off by half its height; so those four are halved to
//  one 5  .  o  o  o  .     cell. All others stay as wide as their neighbours let them. 4  o  .  o
//  .  o
//     4  5  6  7  8
TEST(Quadtree, DividesAroundADrawnPeak) {
  const Place place{Profile::geodetic, 14, 9, 9, 16};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = -2; j <= 18; ++j) {
    for (int i = -2; i <= 18; ++i)
      patch.at(i, j) = i == 6 && j == 6 ? 50 : 0;
  }
  LevelParams level = place.level(1);
  level.baseGrid = 1;
  const Nodes inner = innerNodes(quadtree(patch.tile(), level));
  for (int j = 5; j <= 7; ++j) {
    for (int i = 5; i <= 7; ++i)
      EXPECT_TRUE(inner.count({i, j})) << i << " " << j;
  }
  for (const auto& corner : Nodes{{4, 4}, {8, 4}, {4, 8}, {8, 8}})
    EXPECT_TRUE(inner.count(corner));
  for (const auto& [i, j] : inner) {
    const bool near = i >= 4 && j >= 4 && i <= 8 && j <= 8;
    EXPECT_TRUE(near || (i % 2 == 0 && j % 2 == 0)) << i << " " << j;
  }
  level.maxError = 51;
  EXPECT_TRUE(innerNodes(quadtree(patch.tile(), level)).empty());
}

TEST(Quadtree, KeepsTheMaxErrorOnEveryTerrainAndPlace) {
  unsigned seed = 50;
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      for (const double maxError : {700.0, 40.0, 3.0, 0.2}) {
        SCOPED_TRACE(testing::Message()
                     << place << " " << name(terrain) << " seed " << seed << " " << maxError);
        const Simplified made = quadtree(patch.tile(), place.level(maxError));
        ASSERT_EQ(checkTin(made.tin), "");
        EXPECT_EQ(borderPlaces(made), placesOf(made.border));
        const double reached = measureError(patch.tile(), made.frame, made.tin).max;
        EXPECT_EQ(reached, made.tin.maxError);
        if (made.tin.reason != StopReason::quantization) {
          EXPECT_LE(reached, maxError);
        } else {
          EXPECT_TRUE(maxError < 1.1 * made.level.borderRounding() ||
                      maxError < made.frame.heightStep() || made.frame.coarseStep() > 0);
        }
      }
    }
  }
}

TEST(Quadtree, IsAMeshAtAnyCurvatureAndForAnyObserver) {
  unsigned seed = 300;
  for (const Place& place : places()) {
    const GeoBox box = place.lattice().scheme().box(place.id());
    for (const Terrain terrain : kTerrains) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      for (const char* curvature : {"", "0", "0.3", "20", "1000000"}) {
        for (const bool observed : {false, true}) {
          SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " seed " << seed
                                          << " curvature " << curvature << " " << observed);
          MethodOptions options = curvatureOptions(curvature);
          options.observerRange = 2000;
          if (observed)
            options.observer = {box.west, box.south, 100};
          const Simplified made = quadtree(patch.tile(), place.level(20), options);
          ASSERT_EQ(checkTin(made.tin), "");
          EXPECT_EQ(borderPlaces(made), placesOf(made.border));
        }
      }
    }
  }
}

// A border of any nodes, as other methods or --border inherit may give it.
TEST(Quadtree, FitsItselfToAnyBorder) {
  std::mt19937 random(11);
  const Place place{Profile::geodetic, 12, 1411, 2828, 32};
  for (int round = 0; round < 200; ++round) {
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, unsigned(round));
    Simplified made;
    made.level = place.level(std::ldexp(1, int(random() % 9)));
    made.frame.reset(patch.tile(), made.level);
    const unsigned density = 1 + random() % 12;
    for (auto& places : made.border.places) {
      for (int k = 0; k <= 32; ++k) {
        if (k % 32 != 0 && random() % density != 0)
          continue;
        places.push_back(made.frame.u(k));
        if (k % 32 != 0 && random() % 10 == 0)
          places.push_back(std::uint16_t(made.frame.u(k) + 1));
      }
    }
    const auto method = findSimplifier("quadtree")->create(curvatureOptions(round % 2 ? "3" : ""));
    ASSERT_TRUE(method->simplify(patch.tile(), made.frame, made.border, made.level, made.tin).ok());
    ASSERT_EQ(checkTin(made.tin), "") << round;
    EXPECT_EQ(borderPlaces(made), placesOf(made.border)) << round;
  }
}

TEST(Quadtree, MoreCurvatureAllowedFewerTriangles) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 5);
  std::size_t last = 2 * 64 * 64 + 1;
  for (const char* curvature : {"0.5", "2", "8", "32", "128"}) {
    const std::size_t now =
        quadtree(patch.tile(), place.level(10), curvatureOptions(curvature)).tin.triangles.size();
    EXPECT_LT(now, last) << curvature;
    last = now;
  }
  // Nothing allowed: all nodes, where there is any curvature.
  EXPECT_EQ(quadtree(patch.tile(), place.level(10), curvatureOptions("0")).tin.triangles.size(),
            2u * 64 * 64);
}

TEST(Quadtree, DividesByACurvatureOfItsOwnByDefault) {
  // Nodes of the equator's zoom 12, 64 a tile: 40075 km / 2^13 / 64 = 76.4 m apart.
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 5);
  const double spacing = 2 * wgs84::kPi * wgs84::kSemiMajor / 8192 / 64;
  const MethodOptions said = curvatureOptions(formatNumber(120 * 10 / spacing));
  EXPECT_TRUE(same(quadtree(patch.tile(), place.level(10), MethodOptions()).tin,
                   quadtree(patch.tile(), place.level(10), said).tin));
}

TEST(Quadtree, SeamsHoldByCurvatureAndWithAnObserver) {
  using P = Profile;
  unsigned seed = 900;
  for (const Place& place :
       {Place{P::geodetic, 3, 15, 4, 32}, Place{P::geodetic, 4, 31, 0, 32},
        Place{P::geodetic, 11, 100, 2046, 32}, Place{P::mercator, 14, 77, 12000, 64},
        Place{P::mercator, 2, 3, 2, 16}}) {
    for (const Terrain terrain : {Terrain::fractal, Terrain::spikes, Terrain::steps}) {
      for (const char* curvature : {"", "1", "30"}) {
        for (const bool observed : {false, true}) {
          SCOPED_TRACE(testing::Message()
                       << place << " " << name(terrain) << " " << curvature << " " << observed);
          const TerrainPatch patch(place.lattice(), place.id(), 2, 2, terrain, ++seed);
          MethodOptions options = curvatureOptions(curvature);
          options.observerRange = 1000;
          if (observed)
            options.observer = {179.9, 20, 0};
          const LevelParams level = place.level(15);
          const HeightTile hereTile = patch.tile(0, 0), eastTile = patch.tile(1, 0),
                           northTile = patch.tile(0, 1);
          const Simplified here = quadtree(hereTile, level, options);
          const Simplified east = quadtree(eastTile, level, options);
          const Simplified north = quadtree(northTile, level, options);
          expectSeamless(seam(hereTile, here, kEast), seam(eastTile, east, kWest));
          expectSeamless(seam(hereTile, here, kNorth), seam(northTile, north, kSouth));
        }
      }
    }
  }
}

TEST(Observer, ThresholdsGrowWithDistance) {
  const Place place{Profile::geodetic, 12, 4096, 2048, 64}; // its south-west corner: 0 E, 0 N
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  MethodOptions options;
  EXPECT_EQ(Observer(options).factor(patch.tile(), 0, 0, 4, 4), 1);
  options.observerRange = 1000;
  options.observer = {1, 0, 0};
  const double degree = wgs84::kSemiMajor * 2 * std::sin(wgs84::kPi / 360); // straight
  EXPECT_NEAR(Observer(options).factor(patch.tile(), 0, 0, 0, 0), degree / 1000, 1e-6);
  options.observer = {0.01, 0.01, 0};
  EXPECT_EQ(Observer(options).factor(patch.tile(), 0, 0, 64, 64), 1); // above the box
  options.observer = {0.01, 0.01, 7000};
  EXPECT_NEAR(Observer(options).factor(patch.tile(), 0, 0, 64, 64), 7, 1e-6);
  options.observer = {359, 0, 0}; // a degree to the west
  EXPECT_NEAR(Observer(options).factor(patch.tile(), 0, 0, 64, 64), degree / 1000, 1e-6);
}

TEST(Quadtree, AnObserverSavesTriangles) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const GeoBox box = place.lattice().scheme().box(place.id());
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 5);
  for (const char* curvature : {"", "5"}) {
    MethodOptions options = curvatureOptions(curvature);
    const std::size_t all = quadtree(patch.tile(), place.level(5), options).tin.triangles.size();
    options.observer = {box.west, box.south, 0};
    options.observerRange = 50;
    EXPECT_LT(quadtree(patch.tile(), place.level(5), options).tin.triangles.size(), all / 2);
  }
}

TEST(Quadtree, IsAPureFunctionOfTheTile) {
  const auto reused = findSimplifier("quadtree")->create(curvatureOptions(""));
  for (const Place& place : places()) {
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 31);
    const LevelParams level = place.level(8);
    const Tin fresh = quadtree(patch.tile(), level).tin;
    EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin)) << place;
    EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin)) << place;
  }
}

TEST(Quadtree, WorksOnTheLargestTile) {
  const Place place{Profile::geodetic, 10, 900, 300, 1024};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 21);
  const Simplified made = quadtree(patch.tile(), place.level(60));
  EXPECT_EQ(checkTin(made.tin), "");
  EXPECT_EQ(made.tin.reason, StopReason::maxError);
}

} // namespace
} // namespace qmesh
