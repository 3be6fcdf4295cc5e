// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/inherit/inherit_runner.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "grid/void_fill.h"

namespace qmesh {

/// One level in work.
struct InheritRunner::Level {
  Level(const Scheme& scheme, int zoom, const std::vector<TileRange>& tiles, Schedule order)
      : schedule(scheme, zoom, tiles, order), queue(schedule), edges(scheme.tilesX(zoom)) {}

  TileSchedule schedule;
  TileQueue queue;
  EdgeStore edges;
  const ChunkStore* raw = nullptr;
  const ChunkStore* coarser = nullptr; ///< without voids; null: voids get the constant
  ChunkStore* filled = nullptr;        ///< takes the level without voids; null: nobody needs it
};

/// One thread's buffers.
class InheritRunner::Worker {
 public:
  Worker(const RunContext& context, const KeptTiles& kept, Level& level)
      : context_(context), kept_(kept), level_(level), maker_(context) {}

  Result<BlockResult> run(std::uint32_t index) {
    BlockResult result;
    Stopwatch watch;
    const TileId id = level_.schedule.tile(index);
    QMESH_RETURN_IF_ERROR(load(id));
    result.seconds[int(Step::sample)] += watch.lap();
    takeEdges(index);
    QMESH_RETURN_IF_ERROR(maker_.make(window_.tile(id), kept_, border_, result));
    putEdges(index);
    return result;
  }

  /// The tile's nodes with its halo, voids filled.
  Status load(TileId id) {
    const PyramidPlan& plan = context_.plan();
    const float value = float(context_.options().heights.voidValue);
    window_.reset(plan.lattice(id.z), {id.x, id.y, id.x, id.y}, kTileHalo);
    QMESH_RETURN_IF_ERROR(level_.raw->read(window_));
    window_.setPoles(context_.source().poleHeight(false), context_.source().poleHeight(true));
    if (level_.coarser) {
      const TileId parent = id.parent();
      coarser_.reset(plan.lattice(parent.z), {parent.x, parent.y, parent.x, parent.y}, kTileHalo);
      QMESH_RETURN_IF_ERROR(level_.coarser->read(coarser_));
      fillVoids(coarser_, value);
      fillVoidsOutside(window_, plan.support, value);
      fillVoids(window_, coarser_);
    } else {
      fillVoids(window_, value);
    }
    return level_.filled ? level_.filled->put(window_, id) : Status();
  }

 private:
  void takeEdges(std::uint32_t index) {
    const auto neighbours = level_.schedule.neighbours(index);
    for (std::size_t k = 0; k < 4; ++k) {
      border_.isFree[k] = !neighbours[k] || !comesBefore(*neighbours[k], index);
      if (!border_.isFree[k])
        border_.places[k] = level_.edges.take(level_.schedule.tile(index), Edge(k));
    }
  }

  void putEdges(std::uint32_t index) {
    const auto neighbours = level_.schedule.neighbours(index);
    for (std::size_t k = 0; k < 4; ++k) {
      if (neighbours[k] && comesBefore(index, *neighbours[k]))
        level_.edges.put(level_.schedule.tile(index), Edge(k), border_.places[k]);
    }
  }

  bool comesBefore(std::uint32_t a, std::uint32_t b) const {
    return level_.schedule.rank(a) < level_.schedule.rank(b);
  }

  const RunContext& context_;
  const KeptTiles& kept_;
  Level& level_;
  TileMaker maker_;
  NodeWindow window_, coarser_;
  Border border_;
};

Status InheritRunner::run() {
  QMESH_RETURN_IF_ERROR(stages_.runUp(raw_));
  kept_ = stages_.totals().get().kept;
  for (int zoom = 0; zoom <= context_.plan().maxZoom; ++zoom)
    total_ += kept_.count(zoom);
  for (int zoom = blocks_.stages.back().coarsest; zoom <= context_.plan().maxZoom; ++zoom)
    QMESH_RETURN_IF_ERROR(runLevel(zoom));
  return {};
}

Status InheritRunner::runLevel(int zoom) {
  const bool bridging = context_.options().heights.voidFill == VoidFill::interpolate;
  const bool filling = bridging && zoom < context_.plan().maxZoom;
  filled_ = filling ? stages_.makeStore(zoom, "filled") : nullptr;
  Level level(context_.plan().scheme, zoom, kept_.ranges(zoom), context_.options().tiling.schedule);
  level.raw = raw_[std::size_t(zoom)].get();
  level.coarser = coarser_.get();
  level.filled = filled_.get();
  if (filling)
    QMESH_RETURN_IF_ERROR(fillOthers(level, zoom));
  QMESH_RETURN_IF_ERROR(runTeam(level.schedule.count(), [&] { return work(level); }));
  raw_[std::size_t(zoom)].reset();
  coarser_ = std::move(filled_);
  return {};
}

/// Voids of the tiles that are not written but lie under others.
Status InheritRunner::fillOthers(Level& level, int zoom) {
  std::vector<TileId> others;
  for (const TileRange& r : context_.plan().support.ranges(zoom)) {
    for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
      for (std::uint32_t x = r.x0; x <= r.x1; ++x) {
        if (!kept_.contains({zoom, x, y}))
          others.push_back({zoom, x, y});
      }
    }
  }
  const KeptTiles kept(kept_, context_.plan().maxZoom);
  std::atomic<std::size_t> next{0};
  return runTeam(others.size(), [&]() -> Status {
    Worker worker(context_, kept, level);
    for (std::size_t k = next++; k < others.size() && !context_.control.stop; k = next++)
      QMESH_RETURN_IF_ERROR(worker.load(others[k]));
    return {};
  });
}

Status InheritRunner::runTeam(std::size_t tiles, const std::function<Status()>& work) {
  const std::size_t threads = std::min(std::size_t(blocks_.threads), tiles);
  return team_.run(threads, work, [&] {
    return kUpShare + (1 - kUpShare) * double(context_.control.tilesDone) / double(total_);
  });
}

Status InheritRunner::work(Level& level) {
  const KeptTiles kept(kept_, context_.plan().maxZoom);
  Worker worker(context_, kept, level);
  while (const auto index = level.queue.next(context_.control.stop)) {
    const auto result = worker.run(*index);
    if (!result.ok())
      return result.status();
    stages_.totals().add(*result);
    level.queue.finish(*index);
  }
  return {};
}

} // namespace qmesh
