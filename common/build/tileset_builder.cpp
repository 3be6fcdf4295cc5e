// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "build/tileset_builder.h"

#include "base/stopwatch.h"
#include "build/inherit_runner.h"
#include "build/layer_record.h"
#include "build/stage_runner.h"

namespace qmesh {

namespace {

<<<<<<< HEAD
constexpr std::chrono::milliseconds kProgressInterval(100);
/// Share of the work that the upward pass is, where there is one.
constexpr double kUpShare = 0.3;

/// The stages of a run, one after the other, each by a team of threads that take blocks from a
/// common counter and share nothing else but what BuildShared guards.
class Runner {
 public:
  Runner(BuildShared& shared, const BlockPlan& blocks, const Progress& progress,
         std::string scratch)
      : shared_(shared), blocks_(blocks), progress_(progress), scratch_(std::move(scratch)),
        budget_(std::int64_t(blocks.storeBytes)) {}

  Status run() {
    return shared_.options.voidFill == VoidFill::interpolate ? runUpAndDown() : runWhole();
  }

 private:
  using StorePointer = std::unique_ptr<ChunkStore>;

  StorePointer makeStore(int zoom, const char* kind) {
    return std::make_unique<ChunkStore>(shared_.plan.lattice(zoom), budget_,
                                        scratch_ + "/" + kind + std::to_string(zoom) + ".nodes");
  }

  Status runWhole() {
    StorePointer raw;
    for (const Stage& stage : blocks_.stages) {
      StorePointer coarse = stage.feedsNext ? makeStore(stage.blockZoom, "raw") : nullptr;
      QMESH_RETURN_IF_ERROR(
          runStage(stage, {raw.get(), coarse.get(), nullptr, nullptr}, Pass::whole));
      raw = std::move(coarse);
    }
    return {};
  }

  Status runUpAndDown() {
    const auto& stages = blocks_.stages;
    std::vector<StorePointer> raw(stages.size());
    for (std::size_t k = 0; k < stages.size(); ++k) {
      if (stages[k].feedsNext)
        raw[k] = makeStore(stages[k].blockZoom, "raw");
      const ChunkStore* finer = k > 0 ? raw[k - 1].get() : nullptr;
      QMESH_RETURN_IF_ERROR(runStage(stages[k], {finer, raw[k].get(), nullptr, nullptr}, Pass::up));
    }
    StorePointer coarser;
    for (std::size_t k = stages.size(); k-- > 0;) {
      StorePointer filled = k > 0 ? makeStore(stages[k].finest, "filled") : nullptr;
      const ChunkStore* finer = k > 0 ? raw[k - 1].get() : nullptr;
      QMESH_RETURN_IF_ERROR(
          runStage(stages[k], {finer, nullptr, coarser.get(), filled.get()}, Pass::down));
      raw[k].reset();
      coarser = std::move(filled);
    }
    return {};
  }

  Status runStage(const Stage& stage, const StageStores& stores, Pass pass) {
    next_ = 0;
    const std::size_t count =
        std::min<std::size_t>(std::size_t(blocks_.threads), stage.blocks.size());
    running_ = count;
    std::vector<std::thread> team;
    for (std::size_t k = 0; k < count; ++k) {
      team.emplace_back([&] {
        workSafely(stage, stores, pass);
        const std::lock_guard<std::mutex> lock(mutex_);
        --running_;
        finished_.notify_one();
      });
    }
    watch(stage, pass);
    for (std::thread& member : team)
      member.join();
    if (!status_.ok())
      return status_;
    if (!stores.raw && !interrupted_)
      QMESH_RETURN_IF_ERROR(checkData());
    return interrupted_ ? Status(Code::interrupted, "stopped before the set was complete")
                        : Status();
  }

  /// A DEM between two nodes makes a flat set (the report says so); one without any height none.
  Status checkData() {
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

  /// The calling thread only tells the progress.
  void watch(const Stage& stage, Pass pass) {
    std::unique_lock<std::mutex> lock(mutex_);
    while (running_ > 0) {
      finished_.wait_for(lock, kProgressInterval);
      lock.unlock();
      if (progress_ && !shared_.stop && !progress_(done(stage, pass))) {
        interrupted_ = true;
        shared_.stop = true;
      }
      lock.lock();
    }
  }

  double done(const Stage& stage, Pass pass) const {
    const bool twoPasses = shared_.options.voidFill == VoidFill::interpolate;
    if (pass == Pass::up) {
      const bool first = stage.finest == shared_.plan.maxZoom;
      const double blocks = double(std::min(next_.load(), stage.blocks.size()));
      return first ? kUpShare * blocks / double(stage.blocks.size()) : kUpShare;
    }
    const double tiles = double(shared_.tilesDone) / double(shared_.plan.tileCount());
    return twoPasses ? kUpShare + (1 - kUpShare) * tiles : tiles;
  }

  /// No exception may leave a thread: it would end the process, which may be somebody else's.
  void workSafely(const Stage& stage, const StageStores& stores, Pass pass) {
    try {
      shared_.source.enterThread();
      work(stage, stores, pass);
    } catch (const std::bad_alloc&) {
      fail({Code::internal,
            "not enough memory; a smaller --memory or fewer --num-threads need less"});
    } catch (const std::exception& fault) {
      fail({Code::internal, std::string("a fault of this program: ") + fault.what()});
    }
  }

  void work(const Stage& stage, const StageStores& stores, Pass pass) {
    std::unique_ptr<NodeSource> source;
    if (!stores.raw) {
      auto opened = shared_.source.open(shared_.plan.lattice(stage.finest));
      if (!opened.ok())
        return fail(opened.status());
      source = std::move(*opened);
    }
    BlockJob job(shared_, stage, stores, pass, std::move(source));
    while (!shared_.stop) {
      const std::size_t k = next_++;
      if (k >= stage.blocks.size())
        return;
      const Status status = job.run(stage.blocks[k]);
      if (!status.ok())
        return fail(status);
    }
  }

  void fail(const Status& status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (status_.ok())
      status_ = status;
    shared_.stop = true;
  }

  BuildShared& shared_;
  const BlockPlan& blocks_;
  const Progress& progress_;
  std::string scratch_;
  MemoryBudget budget_;

  std::mutex mutex_; ///< guards status_ and running_
  std::condition_variable finished_;
  Status status_;
  std::size_t running_ = 0;
  bool interrupted_ = false;
  std::atomic<std::size_t> next_{0};
};
=======
Status makeTiles(BuildShared& shared, const BlockPlan& blocks, const std::string& scratch,
                 const Progress& progress) {
  WorkTeam team(shared.stop, progress);
  StageRunner stages(shared, blocks, team, scratch);
  if (shared.options.border == BorderMode::inherit)
    return InheritRunner(shared, blocks, team, stages).run();
  return stages.run();
}
>>>>>>> b0ca838 (--border inherit: a tile takes the edges of neighbours already built, in the order of a schedule, by any number of threads)

BuildReport makeReport(const BuildShared& shared, const BlockPlan& blocks) {
  const PyramidPlan& plan = shared.plan;
  BuildReport report;
  report.input = shared.options.input;
  report.output = shared.options.output;
  report.method = shared.options.method;
  report.minZoom = plan.minZoom;
  report.maxZoom = plan.maxZoom;
  report.cellsPerTile = plan.cells;
  for (const LevelParams& level : plan.levels)
    report.maxErrors.push_back(level.maxError);
  report.levels = shared.levels;
  report.seconds = shared.seconds;
  report.threads = blocks.threads;
  report.blockTiles = blocks.blockTiles;
  report.contentHash = shared.contentHash;
  report.anyData = shared.anyData;
  return report;
}

Result<BuildReport> buildAndCommit(BuildShared& shared, const BlockPlan& blocks,
                                   const std::vector<SideFile>& sideFiles,
                                   const Progress& progress) {
  Stopwatch watch;
  const auto scratch = shared.sink.scratchFolder();
  if (!scratch.ok())
    return scratch.status();
  QMESH_RETURN_IF_ERROR(makeTiles(shared, blocks, *scratch, progress));
  for (const SideFile& file : sideFiles) {
    QMESH_RETURN_IF_ERROR(shared.sink.writeFile(file.first, file.second));
  }
  BuildReport report = makeReport(shared, blocks);
  const LayerJson layer = layerRecord(shared.options, shared.plan, shared.written, report);
  QMESH_RETURN_IF_ERROR(shared.sink.commit(writeLayerJson(layer)));
  report.wallSeconds = watch.lap();
  if (progress)
    progress(1);
  return report;
}

} // namespace

Result<BuildReport> buildTileset(const TilesetInput& input, const BlockPlan& blocks, TileSink& sink,
                                 const std::vector<SideFile>& sideFiles, const Progress& progress) {
  BuildShared shared(input, sink);
  auto report = buildAndCommit(shared, blocks, sideFiles, progress);
  if (!report.ok())
    sink.abandon();
  return report;
}

} // namespace qmesh
