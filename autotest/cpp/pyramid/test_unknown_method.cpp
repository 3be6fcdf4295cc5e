// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/tile_job.h"
#include "synthetic.h"

namespace qmesh {
namespace {

/// A library user may name any method: the command line's parser is not there to refuse it.
class UnknownMethod : public testing::Test {
 protected:
  UnknownMethod() { options_.method.name = "voronoi"; }

  static void expectNamed(const Status& status) {
    EXPECT_EQ(status.code(), Code::usage);
    EXPECT_EQ(status.message().find("unknown method 'voronoi'"), 0u) << status.message();
    EXPECT_NE(status.message().find("greedy"), std::string::npos) << status.message();
  }

  BuildOptions options_ = synthetic::smallOptions();
};

TEST_F(UnknownMethod, IsAnErrorOfTheTileJob) {
  constexpr int kCells = 8;
  const NodeLattice lattice(Scheme(Profile::geodetic), 3, kCells);
  constexpr int kStride = kCells + 1 + 2 * kTileHalo;
  const std::vector<float> heights(std::size_t(kStride) * kStride, 1.0f);
  const HeightTile tile({3, 4, 5}, lattice, heights.data() + kTileHalo * (kStride + 1), kStride);
  const LevelParams level = levelParams(Scheme(Profile::geodetic), 3, 10, kCells);
  TileJob job(options_.method, options_.output);
  TileResult result;
  StepSeconds seconds{};
  expectNamed(job.run(tile, level, nullptr, result, seconds));
  Border border;
  expectNamed(job.run(tile, level, nullptr, border, result, seconds));
}

TEST_F(UnknownMethod, IsAnErrorOfThePlan) {
  expectNamed(planBlocks(options_, options_.run, PyramidPlan(), 1 << 20, 1).status());
}

} // namespace
} // namespace qmesh
