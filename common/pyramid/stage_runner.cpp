// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/stage_runner.h"

#include <algorithm>

namespace qmesh {

StageRunner::StageRunner(BuildShared& shared, const BlockPlan& blocks, WorkTeam& team,
                         std::string scratch)
    : shared_(shared), blocks_(blocks), team_(team), scratch_(std::move(scratch)),
      budget_(std::int64_t(blocks.storeBytes)) {}

Status StageRunner::run() {
  return shared_.options.voidFill == VoidFill::interpolate ? runUpAndDown() : runWhole();
}

StageRunner::StorePointer StageRunner::makeStore(int zoom, const char* kind) {
  return std::make_unique<ChunkStore>(shared_.plan.lattice(zoom), budget_,
                                      scratch_ + "/" + kind + std::to_string(zoom) + ".nodes");
}

Status StageRunner::runWhole() {
  StorePointer raw;
  for (const Stage& stage : blocks_.stages) {
    StorePointer coarse = stage.feedsNext ? makeStore(stage.blockZoom, "raw") : nullptr;
    QMESH_RETURN_IF_ERROR(
        runStage(stage, {raw.get(), coarse.get(), nullptr, nullptr, nullptr}, Pass::whole));
    raw = std::move(coarse);
  }
  return {};
}

Status StageRunner::runUpAndDown() {
  const auto& stages = blocks_.stages;
  std::vector<StorePointer> raw(stages.size());
  for (std::size_t k = 0; k < stages.size(); ++k) {
    if (stages[k].feedsNext)
      raw[k] = makeStore(stages[k].blockZoom, "raw");
    const ChunkStore* finer = k > 0 ? raw[k - 1].get() : nullptr;
    QMESH_RETURN_IF_ERROR(
        runStage(stages[k], {finer, raw[k].get(), nullptr, nullptr, nullptr}, Pass::up));
  }
  StorePointer coarser;
  for (std::size_t k = stages.size(); k-- > 0;) {
    StorePointer filled = k > 0 ? makeStore(stages[k].finest, "filled") : nullptr;
    const ChunkStore* finer = k > 0 ? raw[k - 1].get() : nullptr;
    QMESH_RETURN_IF_ERROR(
        runStage(stages[k], {finer, nullptr, coarser.get(), filled.get(), nullptr}, Pass::down));
    raw[k].reset();
    coarser = std::move(filled);
  }
  return {};
}

Status StageRunner::runUp(std::vector<StorePointer>& levels) {
  levels.clear();
  levels.resize(shared_.plan.levels.size());
  for (int zoom = blocks_.stages.back().coarsest; zoom <= shared_.plan.maxZoom; ++zoom)
    levels[std::size_t(zoom)] = makeStore(zoom, "raw");
  for (const Stage& stage : blocks_.stages) {
    const bool first = stage.finest == shared_.plan.maxZoom;
    const ChunkStore* raw = first ? nullptr : levels[std::size_t(stage.finest)].get();
    QMESH_RETURN_IF_ERROR(runStage(stage, {raw, nullptr, nullptr, nullptr, &levels}, Pass::up));
  }
  return {};
}

Status StageRunner::runStage(const Stage& stage, const StageStores& stores, Pass pass) {
  next_ = 0;
  const std::size_t count =
      std::min<std::size_t>(std::size_t(blocks_.threads), stage.blocks.size());
  QMESH_RETURN_IF_ERROR(team_.run(
      count, [&] { return work(stage, stores, pass); }, [&] { return done(stage, pass); }));
  return stores.raw ? Status() : checkData();
}

/// A DEM between two nodes makes a flat set (the report says so); one without any height none.
Status StageRunner::checkData() {
  if (shared_.anyData)
    return {};
  const auto has = shared_.source.hasData();
  if (!has.ok())
    return has.status();
  if (!*has)
    return {Code::input, shared_.options.input + ": no cell has a height: all are nodata, NaN or "
                                                 "masked; see -a for another nodata value"};
  return {};
}

double StageRunner::done(const Stage& stage, Pass pass) const {
  if (pass == Pass::up) {
    const bool first = stage.finest == shared_.plan.maxZoom;
    const double blocks = double(std::min(next_.load(), stage.blocks.size()));
    return first ? kUpShare * blocks / double(stage.blocks.size()) : kUpShare;
  }
  const double tiles = double(shared_.tilesDone) / double(shared_.plan.tileCount());
  return pass == Pass::down ? kUpShare + (1 - kUpShare) * tiles : tiles;
}

Status StageRunner::work(const Stage& stage, const StageStores& stores, Pass pass) {
  std::unique_ptr<NodeSource> source;
  if (!stores.raw) {
    auto opened = shared_.source.open(shared_.plan.lattice(stage.finest));
    if (!opened.ok())
      return opened.status();
    source = std::move(*opened);
  }
  BlockJob job(shared_, stage, stores, pass, std::move(source));
  while (!shared_.stop) {
    const std::size_t k = next_++;
    if (k >= stage.blocks.size())
      return {};
    QMESH_RETURN_IF_ERROR(job.run(stage.blocks[k]));
  }
  return {};
}

} // namespace qmesh
