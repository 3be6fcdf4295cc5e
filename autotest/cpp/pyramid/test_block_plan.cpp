// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/simplifier.h"
#include "synthetic.h"

namespace qmesh {
namespace {

PyramidPlan planOf(const BuildOptions& options, int zoom) {
  synthetic::Source source;
  source.boxes = {{-180, -90, 180, 90}};
  source.zoom = zoom;
  return *planPyramid(options, source);
}

// Zooms 7..0 in blocks of 8x8: 7 6 5 | 4 3 2 | 1 0
TEST(Stages, ThreeZoomsAtATime) {
  const auto stages = planStages(planOf(synthetic::smallOptions(), 7), 3, 0);
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[0].finest, 7);
  EXPECT_EQ(stages[0].coarsest, 5);
  EXPECT_EQ(stages[0].blockZoom, 4);
  EXPECT_EQ(stages[0].blocks.size(), 32u * 16);
  EXPECT_EQ(stages[1].coarsest, 2);
  EXPECT_EQ(stages[2].finest, 1);
  EXPECT_EQ(stages[2].coarsest, 0);
  EXPECT_FALSE(stages[2].feedsNext);
  EXPECT_EQ(stages[2].blocks.size(), 2u);
}

TEST(Stages, EveryZoomOnceWhateverTheDepth) {
  for (int zoom = 0; zoom <= 7; ++zoom) {
    const PyramidPlan plan = planOf(synthetic::smallOptions(), zoom);
    for (int depth = 1; depth <= 3; ++depth) {
      for (int last = 0; last <= zoom; ++last) {
        int next = zoom;
        const auto stages = planStages(plan, depth, last);
        for (std::size_t k = 0; k < stages.size(); ++k) {
          EXPECT_EQ(stages[k].finest, next);
          EXPECT_LE(stages[k].coarsest, stages[k].finest);
          EXPECT_EQ(stages[k].feedsNext, k + 1 < stages.size());
          next = stages[k].coarsest - 1;
        }
        EXPECT_EQ(next, last - 1);
      }
    }
  }
}

/// The least --memory that the refusal of too little names, bytes.
std::uint64_t minimumOf(BuildOptions options, const PyramidPlan& plan) {
  options.run.memoryBytes = 10 << 20;
  const auto refused = planBlocks(options, options.run, plan, 16 << 20, 4);
  EXPECT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code(), Code::usage);
  const std::string text = refused.status().message();
  const std::size_t at = text.find("at least ");
  EXPECT_NE(at, std::string::npos) << text;
  return at == std::string::npos ? 0 : std::uint64_t(std::stoi(text.substr(at + 9))) << 20;
}

TEST(BlockPlan, StaysWithinMemoryAndNamesTheMinimum) {
  BuildOptions options;
  const PyramidPlan plan = planOf(options, 6);
  options.run.threads = 16;
  for (std::uint64_t mb : {96, 128, 256, 512, 4096}) {
    options.run.memoryBytes = mb << 20;
    const auto blocks = planBlocks(options, options.run, plan, 16 << 20, 4);
    ASSERT_TRUE(blocks.ok()) << blocks.status().message();
    EXPECT_GE(blocks->threads, 1);
    EXPECT_LE(blocks->cacheBytes + blocks->storeBytes, options.run.memoryBytes);
  }
  // The minimum it names is one that works.
  options.run.memoryBytes = minimumOf(options, plan);
  EXPECT_TRUE(planBlocks(options, options.run, plan, 16 << 20, 4).ok());
}

TEST(BlockPlan, CountsWhatTheMethodTakes) {
  BuildOptions options;
  const PyramidPlan plan = planOf(options, 6);
  options.method.name = "greedy";
  const std::uint64_t greedy = minimumOf(options, plan);
  const double nodes = 257.0 * 257.0;
  for (const SimplifierInfo& info : simplifiers()) {
    options.method.name = info.name;
    const double more = double(info.bytesPerNode) - double(findSimplifier("greedy")->bytesPerNode);
    EXPECT_NEAR(double(minimumOf(options, plan)), double(greedy) + more * nodes, 1.0 * (1 << 20))
        << info.name;
  }
}

TEST(BlockPlan, CountsTheEdgesThatWaitUnderInherit) {
  BuildOptions options;
  const PyramidPlan plan = planOf(options, 6);
  const double tiles = double(plan.tiles.count(plan.maxZoom));
  const double shared = double(minimumOf(options, plan));
  options.tiling.border = BorderMode::inherit;
  options.tiling.schedule = Schedule::fourColour;
  // Two edges a tile with a vertex at each of 257 nodes.
  EXPECT_GT(double(minimumOf(options, plan)), shared + tiles * 2 * 2 * 257);
  options.tiling.schedule = Schedule::rowwise;
  EXPECT_LT(double(minimumOf(options, plan)), shared + tiles * 2 * 257);
}

TEST(BlockPlan, SmallSetsAreCutSmallerSoThatAllThreadsWork) {
  BuildOptions options;
  options.run.threads = 2;
  const auto few = planBlocks(options, options.run, planOf(options, 2), 1 << 20, 2);
  const auto many = planBlocks(options, options.run, planOf(options, 8), 1 << 20, 2);
  EXPECT_EQ(few->blockTiles, 2);
  EXPECT_EQ(many->blockTiles, 8);
}

} // namespace
} // namespace qmesh
