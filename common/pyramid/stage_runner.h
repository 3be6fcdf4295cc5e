// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "base/work_team.h"
#include "pyramid/block_job.h"

namespace qmesh {

/// Share of the work that the upward pass is, where there is one.
inline constexpr double kUpShare = 0.3;

/// The stages of a run, one after the other, each by a team of threads that take blocks from a
/// common counter and share nothing else but what BuildShared guards.
class StageRunner {
 public:
  /// Temporary files go to the folder `scratch`.
  StageRunner(BuildShared& shared, const BlockPlan& blocks, WorkTeam& team, std::string scratch);

  using StorePointer = std::unique_ptr<ChunkStore>;

  /// Makes every tile of the plan under --border shared.
  Status run();

  /// The upward pass alone: the nodes of every level (voids not filled), by zoom, for the tiles of
  /// plan.support of the zooms lastZoomNeeded() and on; null below.
  Status runUp(std::vector<StorePointer>& levels);

  StorePointer makeStore(int zoom, const char* kind);

 private:
  Status runWhole();
  Status runUpAndDown();
  Status runStage(const Stage& stage, const StageStores& stores, Pass pass);
  Status checkData();
  double done(const Stage& stage, Pass pass) const;
  Status work(const Stage& stage, const StageStores& stores, Pass pass);

  BuildShared& shared_;
  const BlockPlan& blocks_;
  WorkTeam& team_;
  std::string scratch_;
  MemoryBudget budget_;
  std::atomic<std::size_t> next_{0};
};

} // namespace qmesh
