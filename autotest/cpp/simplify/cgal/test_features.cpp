// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Sharp edges as lines of the mesh, and the border of the point-set methods.
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "../seam.h"
#include "mesh/check.h"
#include "mesh/error_measure.h"
#include "simplify/cgal/feature_lines.h"
#include "simplify/cgal/line_simplify.h"

namespace qmesh {
namespace {

using namespace test;

constexpr const char* kMethods[] = {"grid", "random", "hierarchy", "wlop"};

/// A tile of nodes some metres apart.
const Place kPlace{Profile::geodetic, 14, 9000, 9000, 16};

TerrainPatch flatPatch(const Place& place) {
  return {place.lattice(), place.id(), 1, 1, Terrain::flat, 1};
}

const std::vector<NodeLine>& trace(const HeightTile& tile, FeatureTracer& tracer,
                                   const FeatureRules& rules = {}, bool mayReachBorder = false) {
  MetricNodes positions;
  positions.reset(tile);
  const NodeGrid grid(tile.cells());
  return tracer.trace(tile, positions, rules,
                      std::vector<std::uint8_t>(grid.size(), mayReachBorder));
}

/// The line as places, from its end with the smaller node.
std::vector<std::pair<int, int>> placesOfLine(const NodeLine& line, int cells) {
  const NodeGrid grid(cells);
  std::vector<std::pair<int, int>> nodes;
  for (const NodeIndex node : line)
    nodes.push_back({grid.column(node), grid.row(node)});
  return nodes;
}

//      0 0 0 0 0 0 9 9 9 9        a cliff along column 6: its foot is a line on column 5, its top
//      0 0 0 0 0 0 9 9 9 9        one on column 6, both from the first inner row to the last
TEST(Features, ACliffIsTwoLines) {
  TerrainPatch patch = flatPatch(kPlace);
  for (int j = -2; j <= 18; ++j) {
    for (int i = -2; i <= 18; ++i)
      patch.at(i, j) = i < 6 ? 0.0f : 900.0f;
  }
  FeatureTracer tracer;
  const auto& lines = trace(patch.tile(), tracer);
  ASSERT_EQ(lines.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    const auto nodes = placesOfLine(lines[std::size_t(k)], 16);
    ASSERT_EQ(nodes.size(), 15u);
    for (int j = 1; j < 16; ++j)
      EXPECT_EQ(nodes[std::size_t(j - 1)], std::make_pair(5 + k, j));
  }
  const auto& whole = trace(patch.tile(), tracer, {}, true);
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[0].size(), 17u);
}

TEST(Features, ABlockIsSharpAtItsTopAndFootOnly) {
  TerrainPatch patch = flatPatch(kPlace);
  for (int j = 5; j <= 10; ++j) {
    for (int i = 5; i <= 10; ++i)
      patch.at(i, j) = 500;
  }
  FeatureTracer tracer;
  std::set<std::pair<int, int>> nodes;
  for (const NodeLine& line : trace(patch.tile(), tracer, {60, 1})) {
    for (const auto& node : placesOfLine(line, 16))
      nodes.insert(node);
  }
  const auto distance = [](int i, int j) { // of a node inside the block from its edge, in cells
    return std::min({i - 5, j - 5, 10 - i, 10 - j});
  };
  for (const auto& [i, j] : nodes)
    EXPECT_TRUE(distance(i, j) == 0 || distance(i, j) == -1) << i << " " << j;
  for (int k = 5; k <= 10; ++k)
    EXPECT_TRUE(nodes.count({k, 5}) && nodes.count({5, k}) && nodes.count({k, 4}));
}

TEST(Features, ShortLinesAndBluntEdgesAreLeftOut) {
  TerrainPatch patch = flatPatch(kPlace);
  for (int j = 6; j <= 9; ++j)
    patch.at(7, j) = 500; // a wall of three edges
  FeatureTracer tracer;
  EXPECT_FALSE(trace(patch.tile(), tracer, {60, 1}).empty());
  EXPECT_TRUE(trace(patch.tile(), tracer, {60, 20}).empty());
  EXPECT_TRUE(trace(patch.tile(), tracer, {180, 1}).empty());
  EXPECT_TRUE(trace(flatPatch(kPlace).tile(), tracer, {1, 1}).empty());
}

TEST(Features, NoEdgeIsInTwoLines) {
  for (const Terrain terrain : {Terrain::extreme, Terrain::checkerboard, Terrain::ridged}) {
    const TerrainPatch patch(kPlace.lattice(), kPlace.id(), 1, 1, terrain, 5);
    FeatureTracer tracer;
    std::set<std::pair<NodeIndex, NodeIndex>> edges;
    for (const NodeLine& line : trace(patch.tile(), tracer, {30, 1})) {
      for (std::size_t k = 1; k < line.size(); ++k)
        EXPECT_TRUE(edges.insert(std::minmax(line[k - 1], line[k])).second) << name(terrain);
    }
    EXPECT_FALSE(edges.empty());
  }
}

struct LineCase {
  TileFrame frame;
  std::vector<NodeLine> lines;
};

LineCase simplifyLine(const TerrainPatch& patch, const std::vector<NodeLine>& lines,
                      double maxError) {
  LineCase made;
  made.frame.reset(patch.tile(), kPlace.level(1));
  made.lines = lines;
  simplifyLines(patch.tile(), made.frame, BaseGrid(), maxError, made.lines);
  return made;
}

//  heights along row 8:  0 0 0 0 0 0 50 0 0 0 0
TEST(LineSimplify, KeepsThePeakOfALineAndItsFeet) {
  TerrainPatch patch = flatPatch(kPlace);
  for (int i = 0; i <= 16; ++i)
    patch.at(i, 8) = i == 8 ? 50.0f : 0.0f;
  const NodeGrid grid(16);
  NodeLine line;
  for (int i = 2; i <= 14; ++i)
    line.push_back(grid.index(i, 8));
  const NodeLine expected{grid.index(2, 8), grid.index(7, 8), grid.index(8, 8), grid.index(9, 8),
                          grid.index(14, 8)};
  EXPECT_EQ(simplifyLine(patch, {line}, 1).lines[0], expected);
  const NodeLine ends{grid.index(2, 8), grid.index(14, 8)};
  EXPECT_EQ(simplifyLine(patch, {line}, 51).lines[0], ends);
}

TEST(LineSimplify, ALevelLineStaysAtTheFootOfItsCliff) {
  // Level ground whose edge goes round a corner: the line's heights alone would let it be straight.
  TerrainPatch patch = flatPatch(kPlace);
  for (int j = 0; j <= 16; ++j) {
    for (int i = 0; i <= 16; ++i)
      patch.at(i, j) = i > 8 || j > 8 ? 300.0f : 0.0f;
  }
  const NodeGrid grid(16);
  NodeLine line;
  for (int j = 2; j <= 8; ++j)
    line.push_back(grid.index(8, j));
  for (int i = 7; i >= 2; --i)
    line.push_back(grid.index(i, 8));
  const NodeLine expected{grid.index(8, 2), grid.index(8, 8), grid.index(2, 8)};
  EXPECT_EQ(simplifyLine(patch, {line}, 10).lines[0], expected);
}

TEST(LineSimplify, LinesDoNotComeToCross) {
  // A bow over a straight line: pulled straight it would lie across the other.
  const TerrainPatch patch = flatPatch(kPlace);
  const NodeGrid grid(16);
  NodeLine bow, post{grid.index(8, 5), grid.index(8, 6), grid.index(8, 7)};
  for (int k = 4; k <= 10; ++k)
    bow.push_back(grid.index(4, k));
  for (int k = 5; k <= 12; ++k)
    bow.push_back(grid.index(k, 10));
  for (int k = 9; k >= 4; --k)
    bow.push_back(grid.index(12, k));
  const NodeLine closed{grid.index(6, 12), grid.index(8, 13), grid.index(7, 15), grid.index(6, 12)};
  const auto made = simplifyLine(patch, {bow, post, closed}, 1e5);
  EXPECT_GT(made.lines[0].size(), 2u);
  EXPECT_EQ(made.lines[1], (NodeLine{post.front(), post.back()}));
  EXPECT_EQ(made.lines[2], closed);
}

/// The edges of a mesh by the nodes at their ends.
std::set<std::pair<NodeIndex, NodeIndex>> edgesOf(const Simplified& made) {
  const NodeGrid grid(made.frame.cells());
  const auto node = [&](std::uint32_t v) {
    const TinVertex& vertex = made.tin.vertices[v];
    return grid.index(made.frame.nearestColumn(vertex.u), made.frame.nearestRow(vertex.v));
  };
  std::set<std::pair<NodeIndex, NodeIndex>> edges;
  for (const TinTriangle& t : made.tin.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      edges.insert(std::minmax(node(t[k]), node(t[(k + 1) % 3])));
  }
  return edges;
}

/// A plateau with a bent edge, 400 m above rolling country.
TerrainPatch plateau(const Place& place) {
  TerrainPatch patch = flatPatch(place);
  for (int j = -2; j <= place.cells + 2; ++j) {
    for (int i = -2; i <= place.cells + 2; ++i) {
      const double edge = 30 + 9 * std::sin(j / 11.0);
      patch.at(i, j) = float((i < edge ? 400 : 0) + 3 * std::sin(i / 9.0) * std::cos(j / 7.0));
    }
  }
  return patch;
}

// Figure 4 of EMODnet's report: a cliff with and without features.
TEST(Features, ACliffKeepsItsEdgeWherePointSetsLoseIt) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch = plateau(place);
  const LevelParams level = place.level(8);
  for (const char* method : kMethods) {
    SCOPED_TRACE(method);
    MethodOptions options;
    const Simplified with = simplify(patch.tile(), level, *findSimplifier(method)->create(options));
    options.featureAngle = 180;
    const Simplified without =
        simplify(patch.tile(), level, *findSimplifier(method)->create(options));
    EXPECT_GT(without.tin.maxError, 150);
    EXPECT_LT(with.tin.sumSquaredError, without.tin.sumSquaredError / 20);
    EXPECT_LT(with.tin.triangles.size(), without.tin.triangles.size() * 1.25);
  }
}

TEST(Features, TheirPiecesAreEdgesOfTheMesh) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch = plateau(place);
  const LevelParams level = place.level(8);
  FeatureTracer tracer;
  TileFrame frame;
  frame.reset(patch.tile(), level);
  std::vector<NodeLine> lines = trace(patch.tile(), tracer);
  simplifyLines(patch.tile(), frame, BaseGrid(), level.maxError, lines);
  ASSERT_GE(lines.size(), 2u);
  for (const char* method : kMethods) {
    MethodOptions options;
    options.randomPercent = spec("100"); // no other node on a piece
    options.retainPercent = spec("0");
    options.cellSize = options.clusterSize = spec("1e9");
    options.maxVariance = spec("0.33");
    LevelParams bare = level;
    bare.baseGrid = 1;
    const Simplified made = simplify(patch.tile(), bare, *findSimplifier(method)->create(options));
    EXPECT_EQ(checkTin(made.tin), "");
    const auto edges = edgesOf(made);
    for (const NodeLine& line : lines) {
      for (std::size_t k = 1; k < line.size(); ++k)
        EXPECT_TRUE(edges.count(std::minmax(line[k - 1], line[k]))) << method;
    }
  }
}

TEST(PointSetBorder, SeamsHoldWithABorderOfItsOwn) {
  MethodOptions options;
  options.iterations = 1;
  unsigned seed = 40;
  for (const Place& place :
       {Place{Profile::geodetic, 3, 15, 4, 32}, Place{Profile::mercator, 2, 3, 1, 64},
        Place{Profile::geodetic, 11, 100, 2046, 16}}) {
    for (const Terrain terrain : kTerrains) {
      for (const char* error : {"0", "4", "500"}) {
        for (const char* length : {"100", "20", "1"}) {
          options.borderMaxError = spec(error);
          options.borderMaxLength = spec(length);
          SCOPED_TRACE(testing::Message()
                       << place << " " << name(terrain) << " " << error << " " << length);
          const bool twoRows = place.y + 1 < place.lattice().scheme().tilesY(place.zoom);
          const TerrainPatch patch(place.lattice(), place.id(), 2, twoRows ? 2 : 1, terrain,
                                   ++seed);
          const LevelParams level = place.level(60);
          const auto random = findSimplifier("random")->create(options);
          const HeightTile tile = patch.tile(0, 0), eastTile = patch.tile(1, 0);
          const Simplified here = simplify(tile, level, *random);
          expectSeamless(seam(tile, here, kEast),
                         seam(eastTile, simplify(eastTile, level, *random), kWest));
          if (twoRows) {
            const HeightTile northTile = patch.tile(0, 1);
            expectSeamless(seam(tile, here, kNorth),
                           seam(northTile, simplify(northTile, level, *random), kSouth));
          }
        }
      }
    }
  }
}

TEST(PointSetBorder, FollowsItsTwoOptions) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 9);
  LevelParams level = place.level(20);
  level.baseGrid = 1;
  const auto made = [&](const char* error, const char* length) {
    MethodOptions options;
    options.borderMaxError = spec(error);
    options.borderMaxLength = spec(length);
    return simplify(patch.tile(), level, *findSimplifier("grid")->create(options)).border;
  };
  EXPECT_EQ(made("1e5", "")[kSouth].size(), 2u);
  EXPECT_EQ(made("1e5", "50")[kSouth].size(), 3u);
  EXPECT_EQ(made("1e5", "49")[kSouth].size(), 5u);
  EXPECT_EQ(made("1e5", "0.1")[kSouth].size(), 65u);
  EXPECT_LT(made("80", "")[kSouth].size(), made("", "")[kSouth].size());
  EXPECT_GT(made("2", "")[kSouth].size(), made("", "")[kSouth].size());
}

TEST(PointSetBorder, AFreeEdgeGetsTheFeaturesThatReachIt) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch = plateau(place);
  const LevelParams level = place.level(8);
  for (const char* method : kMethods) {
    const auto simplifier = findSimplifier(method)->create({});
    Simplified made;
    made.frame.reset(patch.tile(), level);
    simplifier->makeBorder(patch.tile(), made.frame, level, made.border);
    made.border[kNorth] = {0, kQuantizedMax};
    made.border.isFree[kNorth] = true;
    ASSERT_TRUE(simplifier->simplify(patch.tile(), made.frame, made.border, level, made.tin).ok());
    EXPECT_EQ(checkTin(made.tin), "") << method;
    std::set<int> columns;
    for (const auto& [u, v] : borderPlaces(made)) {
      if (v == kQuantizedMax)
        columns.insert(made.frame.nearestColumn(std::uint16_t(u)));
    }
    const int top = int(std::ceil(30 + 9 * std::sin(64 / 11.0))) - 1;
    EXPECT_TRUE(columns.count(top)) << method;
    EXPECT_TRUE(columns.count(top + 1)) << method;
    const ErrorMeasure measure = measureError(patch.tile(), made.frame, made.tin);
    EXPECT_LT(measure.max, 100) << method;
  }
}

} // namespace
} // namespace qmesh
