// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/work_team.h"
#include "pyramid/blocks/block_scheduler.h"
#include "pyramid/blocks/upward_job.h"
#include "pyramid/run_context.h"

namespace qmesh {

/// Share of the work that the upward pass is, where there is one.
inline constexpr double kUpShare = 0.3;

/// Runs the stages one after the other, each by a team of threads that take blocks from the
/// scheduler, and merges what they return.
class StageRunner {
 public:
  /// Temporary files go to the folder `scratch`.
  StageRunner(const RunContext& context, const BlockPlan& blocks, BlockScheduler& scheduler,
              WorkTeam& team, std::string scratch);

  using StorePointer = std::unique_ptr<ChunkStore>;

  /// Makes every tile of the plan under --border shared.
  Status run();

  /// The upward pass alone: the nodes of every level (voids not filled), by zoom, for the tiles of
  /// plan.support of the zooms lastZoomNeeded() and on; null below.
  Status runUp(std::vector<StorePointer>& levels);

  StorePointer makeStore(int zoom, const char* kind);

  /// What has been made so far.
  RunTotals& totals() { return totals_; }

 private:
  using JobPointer = std::unique_ptr<BlockJob>;
  /// Makes a job for one thread.
  using JobMaker = std::function<Result<JobPointer>()>;
  using Done = std::function<double()>;

  Status runWhole();
  Status runUpAndDown();
  Status runUpStage(const Stage& stage, const ChunkStore* finer, const NodeStores& stores,
                    TileMaking making);
  Status runDownStage(const Stage& stage, const ChunkStore* finer, const KeptTiles& kept,
                      const ChunkStore* above, ChunkStore* finest);
  Status runBlocks(const Stage& stage, const JobMaker& makeJob, const Done& done);
  Status work(const Stage& stage, const JobMaker& makeJob);
  Result<std::unique_ptr<FinestNodes>> finestNodes(const Stage& stage,
                                                   const ChunkStore* finer) const;
  /// No store for any level but, where `coarse` is one, the level that the next stage begins with.
  NodeStores storesFor(const Stage& stage, ChunkStore* coarse) const;
  Status checkData();
  double tilesDone() const;
  double upDone(const Stage& stage) const;

  const RunContext& context_;
  const BlockPlan& blocks_;
  BlockScheduler& scheduler_;
  WorkTeam& team_;
  std::string scratch_;
  MemoryBudget budget_;
  RunTotals totals_;
};

} // namespace qmesh
