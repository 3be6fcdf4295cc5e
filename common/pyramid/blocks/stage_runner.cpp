// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/stage_runner.h"

#include <algorithm>
#include <utility>

#include "pyramid/blocks/downward_job.h"

namespace qmesh {

StageRunner::StageRunner(const RunContext& context, const BlockPlan& blocks,
                         BlockScheduler& scheduler, WorkTeam& team, std::string scratch)
    : context_(context), blocks_(blocks), scheduler_(scheduler), team_(team),
      scratch_(std::move(scratch)), budget_(std::int64_t(blocks.storeBytes)) {}

Status StageRunner::run() {
  return context_.options().heights.voidFill == VoidFill::interpolate ? runUpAndDown() : runWhole();
}

StageRunner::StorePointer StageRunner::makeStore(int zoom, const char* kind) {
  return std::make_unique<ChunkStore>(context_.plan().lattice(zoom), budget_,
                                      scratch_ + "/" + kind + std::to_string(zoom) + ".nodes");
}

NodeStores StageRunner::storesFor(const Stage& stage, ChunkStore* coarse) const {
  NodeStores stores(context_.plan().levels.size(), nullptr);
  if (coarse)
    stores[std::size_t(stage.blockZoom)] = coarse;
  return stores;
}

Status StageRunner::runWhole() {
  StorePointer finer;
  for (const Stage& stage : blocks_.stages) {
    StorePointer coarse = stage.feedsNext ? makeStore(stage.blockZoom, "raw") : nullptr;
    QMESH_RETURN_IF_ERROR(
        runUpStage(stage, finer.get(), storesFor(stage, coarse.get()), TileMaking::constantFill));
    finer = std::move(coarse);
  }
  return {};
}

Status StageRunner::runUpAndDown() {
  const auto& stages = blocks_.stages;
  std::vector<StorePointer> raw(stages.size()); ///< fed by a stage, read by the next
  const auto finer = [&](std::size_t k) { return k > 0 ? raw[k - 1].get() : nullptr; };
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (stages[k].feedsNext)
      raw[k] = makeStore(stages[k].blockZoom, "raw");
    QMESH_RETURN_IF_ERROR(
        runUpStage(stages[k], finer(k), storesFor(stages[k], raw[k].get()), TileMaking::none));
  }
  const Availability all = totals_.get().kept;
  const KeptTiles kept(all, context_.plan().maxZoom);
  StorePointer above;
  for (std::size_t k = stages.size(); k-- > 0;) {
    StorePointer filled = k > 0 ? makeStore(stages[k].finest, "filled") : nullptr;
    QMESH_RETURN_IF_ERROR(runDownStage(stages[k], finer(k), kept, above.get(), filled.get()));
    raw[k].reset();
    above = std::move(filled);
  }
  return {};
}

Status StageRunner::runUp(std::vector<StorePointer>& levels) {
  levels.clear();
  levels.resize(context_.plan().levels.size());
  for (int zoom = blocks_.stages.back().coarsest; zoom <= context_.plan().maxZoom; ++zoom)
    levels[std::size_t(zoom)] = makeStore(zoom, "raw");
  for (const Stage& stage : blocks_.stages) {
    NodeStores stores;
    for (const StorePointer& level : levels)
      stores.push_back(level.get());
    const ChunkStore* finer = nullptr;
    if (stage.finest < context_.plan().maxZoom) // that level is stored already
      finer = std::exchange(stores[std::size_t(stage.finest)], nullptr);
    QMESH_RETURN_IF_ERROR(runUpStage(stage, finer, stores, TileMaking::none));
  }
  return {};
}

Result<std::unique_ptr<FinestNodes>> StageRunner::finestNodes(const Stage& stage,
                                                              const ChunkStore* finer) const {
  if (finer)
    return storedNodes(*finer);
  return sampledNodes(context_.plan(), context_.source(), stage.finest);
}

Status StageRunner::runUpStage(const Stage& stage, const ChunkStore* finer,
                               const NodeStores& stores, TileMaking making) {
  const Availability kept = totals_.get().kept; // of earlier stages: this one's is merged later
  const JobMaker makeJob = [&]() -> Result<JobPointer> {
    auto finest = finestNodes(stage, finer);
    if (!finest.ok())
      return finest.status();
    return JobPointer(
        std::make_unique<UpwardJob>(context_, stage, kept, *std::move(finest), stores, making));
  };
  QMESH_RETURN_IF_ERROR(runBlocks(
      stage, makeJob, [&] { return making == TileMaking::none ? upDone(stage) : tilesDone(); }));
  return finer ? Status() : checkData();
}

Status StageRunner::runDownStage(const Stage& stage, const ChunkStore* finer, const KeptTiles& kept,
                                 const ChunkStore* above, ChunkStore* finest) {
  const JobMaker makeJob = [&]() -> Result<JobPointer> {
    auto nodes = finestNodes(stage, finer);
    if (!nodes.ok())
      return nodes.status();
    return JobPointer(std::make_unique<DownwardJob>(context_, stage, kept, *std::move(nodes),
                                                    DownwardJob::Stores{above, finest}));
  };
  return runBlocks(stage, makeJob, [this] { return kUpShare + (1 - kUpShare) * tilesDone(); });
}

/// A DEM between two nodes makes a flat tileset (the report says so); one without any height none.
Status StageRunner::checkData() {
  if (totals_.get().anyData)
    return {};
  const auto has = context_.source().hasData();
  if (!has.ok())
    return has.status();
  if (!*has)
    return {Code::input, context_.options().input.path +
                             ": no cell has a height: all are nodata, NaN or "
                             "masked; see -a for another nodata value"};
  return {};
}

double StageRunner::tilesDone() const {
  return double(context_.control.tilesDone) / double(context_.plan().tileCount());
}

/// Nearly all of an upward pass is its first stage.
double StageRunner::upDone(const Stage& stage) const {
  const bool first = stage.finest == context_.plan().maxZoom;
  return first ? kUpShare * double(scheduler_.given()) / double(stage.blocks.size()) : kUpShare;
}

Status StageRunner::runBlocks(const Stage& stage, const JobMaker& makeJob, const Done& done) {
  scheduler_.begin(stage.blocks.size());
  const std::size_t threads =
      std::min<std::size_t>(std::size_t(blocks_.threads), stage.blocks.size());
  return team_.run(
      threads, [&] { return work(stage, makeJob); }, done);
}

/// What one thread does in a pass.
Status StageRunner::work(const Stage& stage, const JobMaker& makeJob) {
  const auto job = makeJob();
  if (!job.ok())
    return job.status();
  while (!context_.control.stop) {
    const auto block = scheduler_.next();
    if (!block)
      return {};
    const auto result = (*job)->run(stage.blocks[*block]);
    if (!result.ok())
      return result.status();
    if (context_.control.stop)
      return {}; // the result may be incomplete
    totals_.add(*result);
  }
  return {};
}

} // namespace qmesh
