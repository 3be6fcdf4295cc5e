// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "synthetic.h"

namespace qmesh {
namespace {

using synthetic::Source;

Result<PyramidPlan> plan(const BuildOptions& options, const std::vector<GeoBox>& boxes, int zoom) {
  Source source;
  source.boxes = boxes;
  source.zoom = zoom;
  return planPyramid(options, source);
}

// A box that ends on a tile's edge does not touch the tile beyond.
TEST(PyramidPlan, TilesThatMeetTheExtent) {
  const auto p = plan({}, {{0, 0, 45, 45}}, 3);
  ASSERT_TRUE(p.ok());
  EXPECT_EQ(p->tiles.ranges(3), (std::vector<TileRange>{{8, 4, 9, 5}}));
  EXPECT_EQ(p->tiles.ranges(2), (std::vector<TileRange>{{4, 2, 4, 2}}));
  EXPECT_EQ(p->tiles.ranges(0), (std::vector<TileRange>{{0, 0, 1, 0}}));
}

TEST(PyramidPlan, NoiseOnAnEdgeIsNoTile) {
  const auto p = plan({}, {{-1e-13, -1e-13, 45 + 1e-13, 45 + 1e-13}}, 3);
  ASSERT_TRUE(p.ok());
  EXPECT_EQ(p->tiles.ranges(3), (std::vector<TileRange>{{8, 4, 9, 5}}));
}

TEST(PyramidPlan, OverlappingBoxesMakeATileOnce) {
  const auto p = plan({}, {{0, 0, 45, 45}, {20, 20, 60, 60}, {0, 0, 45, 45}}, 3);
  ASSERT_TRUE(p.ok());
  std::uint64_t tiles = 0;
  for (const TileRange& r : p->tiles.ranges(3))
    tiles += r.count();
  EXPECT_EQ(tiles, p->tiles.count(3));
  EXPECT_EQ(tiles, 9u); // the first box lies within the tiles of the second
}

TEST(PyramidPlan, BothSidesOfTheAntimeridian) {
  const auto p = plan({}, {{179, -1, 182, 1}}, 6);
  ASSERT_TRUE(p.ok());
  EXPECT_TRUE(p->tiles.contains({6, 127, 31}));
  EXPECT_TRUE(p->tiles.contains({6, 0, 32}));
  EXPECT_EQ(p->tiles.count(6), 4u);
}

TEST(PyramidPlan, APointGetsOneTile) {
  const auto p = plan({}, {{10, 20, 10, 20}}, 5);
  ASSERT_TRUE(p.ok());
  EXPECT_EQ(p->tiles.count(5), 1u);
}

TEST(PyramidPlan, PartsOfTheMatrix) {
  BuildOptions options;
  options.tiling.minX = 5;
  options.tiling.maxX = 6;
  options.tiling.maxY = 2;
  const auto p = plan(options, {{-180, -90, 180, 90}}, 3);
  ASSERT_TRUE(p.ok());
  EXPECT_EQ(p->tiles.ranges(3), (std::vector<TileRange>{{5, 0, 6, 2}}));
  options.tiling.minX = 90;
  options.tiling.maxX = 95;
  EXPECT_EQ(plan(options, {{-180, -90, 180, 90}}, 3).status().code(), Code::usage);
}

TEST(PyramidPlan, MaxErrorFromTheScreen) {
  const auto p = plan({}, {{0, 0, 1, 1}}, 4);
  ASSERT_TRUE(p.ok());
  const double root = 6378137 * 2 * 3.14159265358979323846 * 0.25 / (65 * 2);
  EXPECT_NEAR(p->levels[0].maxError, root / 4, 1e-6);
  EXPECT_NEAR(p->levels[3].maxError, root / 4 / 8, 1e-6);
  EXPECT_NEAR(p->levels[4].maxError, root / 4 / 16 / 2, 1e-6);
  BuildOptions options;
  options.method.maxError = LevelSpec(7);
  EXPECT_EQ(plan(options, {{0, 0, 1, 1}}, 4)->levels[4].maxError, 7);
  options.method.maxError = *LevelSpec::parse("0:7");
  EXPECT_EQ(plan(options, {{0, 0, 1, 1}}, 4).status().code(), Code::usage);
}

TEST(PyramidPlan, ZoomsThatMakeNoSense) {
  BuildOptions options;
  options.tiling.minZoom = 5;
  options.tiling.maxZoom = 3;
  EXPECT_EQ(plan(options, {{0, 0, 1, 1}}, 4).status().code(), Code::usage);
  EXPECT_EQ(plan({}, {}, 4).status().code(), Code::input);
}

} // namespace
} // namespace qmesh
