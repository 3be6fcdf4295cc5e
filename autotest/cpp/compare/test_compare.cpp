// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>

#include "compare/compare.h"
#include "compare/monotone_search.h"
#include "simplify/simplifier.h"
#include "synthetic.h"

namespace qmesh {
namespace {

using synthetic::Source;

TEST(SearchMonotone, FindsTheArgumentEitherWay) {
  for (const bool rising : {true, false}) {
    int calls = 0;
    const auto found = searchMonotone(1e-4, 1e7, 500, 0.01, [&](double x) -> Result<double> {
      ++calls;
      return rising ? 3 * x : 1e6 / x;
    });
    ASSERT_TRUE(found.ok());
    EXPECT_TRUE(found->reached);
    EXPECT_NEAR(found->outcome, 500, 5);
    EXPECT_NEAR(found->value, rising ? 500 / 3.0 : 2000, 30);
    EXPECT_LT(calls, 20);
  }
}

TEST(SearchMonotone, SaysWhereTheTargetIsOutOfReach) {
  const auto found =
      searchMonotone(1, 100, 5000, 0.01, [](double x) -> Result<double> { return 10 * x; });
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found->reached);
  EXPECT_EQ(found->value, 100);
  EXPECT_EQ(found->outcome, 1000);
}

TEST(SearchMonotone, TakesTheNearerSideOfAStep) {
  const auto found =
      searchMonotone(1, 100, 50, 0.01, [](double x) -> Result<double> { return x < 30 ? 10 : 60; });
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found->reached);
  EXPECT_EQ(found->outcome, 60);
}

TEST(SearchMonotone, PassesAFaultOn) {
  const auto found = searchMonotone(
      1, 100, 50, 0.01, [](double) -> Result<double> { return Status(Code::internal, "no"); });
  EXPECT_EQ(found.status().message(), "no");
}

class Compared : public testing::Test {
 protected:
  Compared() {
    source_.boxes = {{10, 46, 13, 48}};
    source_.zoom = 8;
    options_ = synthetic::smallOptions();
    options_.tiling.tileSize = 32;
    options_.output.compression = Compression::gzip;
    options_.method.maxError = LevelSpec(5);
  }

  Comparison compare() {
    const auto plan = planPyramid(options_, source_);
    EXPECT_TRUE(plan.ok());
    const TilesetInput input{options_, *plan, source_};
    const auto tiles = chooseComparedTiles(input);
    EXPECT_TRUE(tiles.ok()) << tiles.status().message();
    auto comparison = compareMethods(input, *tiles, {});
    EXPECT_TRUE(comparison.ok()) << comparison.status().message();
    return *comparison;
  }

  /// With the fixture's own options, made once.
  const Comparison& usual() {
    static const Comparison comparison = compare();
    return comparison;
  }

  Source source_;
  BuildOptions options_;
};

TEST_F(Compared, EveryMethodIsThereAtEveryTarget) {
  const Comparison& comparison = usual();
  for (const auto& rows : comparison.targets) {
    ASSERT_EQ(rows.size(), simplifiers().size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      EXPECT_EQ(rows[k].method, simplifiers()[k].name);
      EXPECT_EQ(rows[k].quality.nodes, 33u * 33u);
      EXPECT_EQ(rows[k].mesh.triangles.size(), rows[k].triangles);
      EXPECT_GT(rows[k].bytes, 0u);
    }
  }
}

TEST_F(Compared, WhatIsSaidToBeReachedIs) {
  const Comparison& comparison = usual();
  int reached = 0;
  for (const ComparedMethod& row : comparison.targets[std::size_t(CompareTarget::count)]) {
    if (row.reached) {
      EXPECT_NEAR(double(row.triangles), double(comparison.triangles),
                  0.0101 * double(comparison.triangles));
    }
    reached += row.reached ? 1 : 0;
  }
  for (const ComparedMethod& row : comparison.targets[std::size_t(CompareTarget::error)]) {
    if (row.reached) {
      EXPECT_NEAR(row.quality.height.max, comparison.maxError, 0.0101 * comparison.maxError);
    }
  }
  EXPECT_GE(reached, 1); // the reference itself at least
  const ComparedMethod& all = comparison.targets[std::size_t(CompareTarget::count)].back();
  EXPECT_EQ(all.method, "delaunay");
  EXPECT_FALSE(all.reached);
}

/// A bump in one tile of a plain.
TEST_F(Compared, TheBusiestTileIsChosen) {
  source_.isVoid = [](double lon, double lat) {
    return lon < 10.6 || lon > 11.2 || lat < 46.45 || lat > 47.05; // filled with 0
  };
  const auto plan = planPyramid(options_, source_);
  const auto tiles = chooseComparedTiles({options_, *plan, source_});
  ASSERT_TRUE(tiles.ok());
  ASSERT_EQ(tiles->size(), 1u);
  const TileId busiest = tiles->front();
  EXPECT_TRUE(busiest == (TileId{8, 271, 194})) << busiest.x << " " << busiest.y;
}

TEST_F(Compared, ARegionIsAllItsTiles) {
  options_.tiling.tileSize = 16;
  options_.tiling.minX = 271;
  options_.tiling.maxX = 272;
  options_.tiling.minY = 194;
  options_.tiling.maxY = 195;
  const Comparison comparison = compare();
  EXPECT_EQ(comparison.tiles.size(), 4u);
  const ComparedMethod& row = comparison.targets[0].front();
  EXPECT_EQ(row.quality.nodes, 4u * 17 * 17);
  EXPECT_NEAR(row.mesh.box.east - row.mesh.box.west, 2 * 0.703125, 1e-9);
  double west = 1e9, east = -1e9;
  for (const ExportVertex& vertex : row.mesh.vertices) {
    west = std::min(west, vertex.u);
    east = std::max(east, vertex.u);
  }
  EXPECT_NEAR(west, 0, 1e-6);
  EXPECT_NEAR(east, 32767, 1e-6);
}

TEST_F(Compared, TooLargeARegionIsRefused) {
  source_.boxes = {{-180, -90, 180, 90}};
  options_.tiling.minX = 0;
  const auto plan = planPyramid(options_, source_);
  const auto tiles = chooseComparedTiles({options_, *plan, source_});
  ASSERT_FALSE(tiles.ok());
  EXPECT_EQ(tiles.status().code(), Code::usage);
}

TEST_F(Compared, CanBeStopped) {
  const auto plan = planPyramid(options_, source_);
  const auto comparison =
      compareMethods({options_, *plan, source_}, {{8, 271, 194}}, [](double) { return false; });
  ASSERT_FALSE(comparison.ok());
  EXPECT_EQ(comparison.status().code(), Code::interrupted);
}

TEST_F(Compared, TheCsvIsTheSameEveryTime) {
  const std::string csv = comparisonCsv(usual());
  EXPECT_EQ(csv, comparisonCsv(compare()));
  EXPECT_EQ(std::size_t(std::count(csv.begin(), csv.end(), '\n')), 1 + 3 * simplifiers().size());
}

} // namespace
} // namespace qmesh
