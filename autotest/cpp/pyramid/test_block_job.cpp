// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// A block is a function: what it returns and stores depends on the block and earlier stages alone.
#include <algorithm>
#include <random>

#include "pyramid/blocks/upward_job.h"
#include "synthetic.h"

namespace qmesh {
namespace {

using synthetic::Sink;
using synthetic::Source;

/// Gives out the blocks of a pass in an order of its own.
class OrderedScheduler : public BlockScheduler {
 public:
  using Order = std::function<void(std::vector<std::size_t>&)>;
  explicit OrderedScheduler(Order order) : order_(std::move(order)) {}

  void begin(std::size_t count) override {
    blocks_.resize(count);
    for (std::size_t k = 0; k < count; ++k)
      blocks_[k] = k;
    order_(blocks_);
    next_ = 0;
  }
  std::optional<std::size_t> next() override {
    const std::size_t k = next_++;
    return k < blocks_.size() ? std::optional<std::size_t>(blocks_[k]) : std::nullopt;
  }
  std::size_t given() const override { return std::min(next_.load(), blocks_.size()); }

 private:
  Order order_;
  std::vector<std::size_t> blocks_;
  std::atomic<std::size_t> next_{0};
};

class BlockJobTest : public testing::Test {
 protected:
  BlockJobTest() {
    source_.boxes = {{-30, -20, 40, 30}};
    source_.zoom = 6;
    source_.isVoid = [](double lon, double lat) {
      return std::fmod(std::abs(std::floor(lon / 2) * 7 + std::floor(lat / 2) * 13), 5) < 3;
    };
    options_ = synthetic::smallOptions();
    options_.tiling.excludeVoid = true;
    options_.output.metadata = 2;
    options_.run.blockTiles = 4;
    plan_ = *planPyramid(options_, source_);
    blocks_ = *planBlocks(options_, options_.run, plan_, source_.bytesPerSource(), 1);
  }

  TilesetInput input() const { return {options_, plan_, source_}; }

  /// One block of the first stage by a job of its own.
  BlockResult runBlock(TileId block, Sink& sink) {
    const TilesetInput in = input();
    const RunContext context{in, sink, control_};
    const Stage& stage = blocks_.stages.front();
    auto finest = sampledNodes(plan_, source_, stage.finest);
    EXPECT_TRUE(finest.ok());
    const Availability none;
    UpwardJob job(context, stage, none, *std::move(finest),
                  NodeStores(plan_.levels.size(), nullptr), TileMaking::constantFill);
    auto result = job.run(block);
    EXPECT_TRUE(result.ok()) << result.status().message();
    return *result;
  }

  void expectSame(const BlockResult& a, const BlockResult& b) const {
    EXPECT_EQ(a.anyData, b.anyData);
    EXPECT_EQ(a.contentHash, b.contentHash);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t z = 0; z < a.levels.size(); ++z) {
      EXPECT_EQ(a.levels[z].tiles, b.levels[z].tiles);
      EXPECT_EQ(a.levels[z].triangles, b.levels[z].triangles);
      EXPECT_EQ(a.levels[z].sumSquaredError, b.levels[z].sumSquaredError);
      EXPECT_EQ(a.levels[z].maxError, b.levels[z].maxError);
    }
    for (int z = 0; z <= plan_.maxZoom; ++z)
      EXPECT_EQ(a.kept.ranges(z), b.kept.ranges(z)) << "zoom " << z;
  }

  Source source_;
  BuildOptions options_;
  PyramidPlan plan_;
  BlockPlan blocks_;
  RunControl control_;
};

TEST_F(BlockJobTest, RunAgainGivesTheSameResultAndTiles) {
  std::uint64_t tiles = 0;
  for (const TileId block : blocks_.stages.front().blocks) {
    Sink first, second;
    const BlockResult result = runBlock(block, first);
    expectSame(result, runBlock(block, second));
    EXPECT_EQ(first.files, second.files);
    for (const LevelStats& level : result.levels)
      tiles += level.tiles;
    std::uint64_t kept = 0;
    for (int z = 0; z <= plan_.maxZoom; ++z)
      kept += result.kept.count(z);
    EXPECT_EQ(kept, first.files.size()) << "a tile that is kept is stored, no other";
  }
  EXPECT_GT(tiles, 100u);
}

TEST_F(BlockJobTest, ResultsAddUpInAnyOrder) {
  std::vector<BlockResult> results;
  for (const TileId block : blocks_.stages.front().blocks) {
    Sink sink;
    results.push_back(runBlock(block, sink));
  }
  RunTotals forward, shuffled;
  for (const BlockResult& result : results)
    forward.add(result);
  std::shuffle(results.begin(), results.end(), std::mt19937(7));
  for (const BlockResult& result : results)
    shuffled.add(result);
  expectSame(forward.get(), shuffled.get());
}

TEST_F(BlockJobTest, AStoppedBlockMakesNoTileAndIsNoFailure) {
  control_.stop = true;
  Sink sink;
  (void)runBlock(blocks_.stages.front().blocks.front(), sink);
  EXPECT_TRUE(sink.files.empty());
}

TEST_F(BlockJobTest, TheOrderOfBlocksChangesNoByte) {
  for (const VoidFill fill : {VoidFill::value, VoidFill::interpolate}) {
    options_.heights.voidFill = fill;
    Sink reference;
    synthetic::build(options_, source_, reference);
    for (int order = 0; order < 3; ++order) {
      OrderedScheduler scheduler([order](std::vector<std::size_t>& blocks) {
        if (order == 0)
          std::reverse(blocks.begin(), blocks.end());
        else
          std::shuffle(blocks.begin(), blocks.end(), std::mt19937(unsigned(order)));
      });
      BlockPlan blocks = blocks_;
      blocks.threads = 1 + order;
      Sink sink;
      const auto report =
          buildTileset(input(), blocks, scheduler, {sink, sink.scratch()}, Progress());
      ASSERT_TRUE(report.ok()) << report.status().message();
      EXPECT_EQ(reference.files, sink.files);
    }
  }
}

} // namespace
} // namespace qmesh
