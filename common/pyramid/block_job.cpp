// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/block_job.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "grid/reduce.h"
#include "grid/void_fill.h"

namespace qmesh {

namespace {

/// The smallest rectangle of tiles of `zoom` around the block's planned tiles of all the stage's
/// levels. Each level's window is this one times a power of two, so that a coarse node's stencil
/// lies in the finer window wherever there can be data.
TileRange coarsestTiles(const PyramidPlan& plan, const Stage& stage, TileId block) {
  TileRange box{UINT32_MAX, UINT32_MAX, 0, 0};
  for (int z = stage.finest; z >= stage.coarsest; --z) {
    const int up = z - stage.coarsest;
    for (const TileRange& r : plan.support.rangesUnder(block, z)) {
      box = {std::min(box.x0, r.x0 >> up), std::min(box.y0, r.y0 >> up),
             std::max(box.x1, r.x1 >> up), std::max(box.y1, r.y1 >> up)};
    }
  }
  return box;
}

} // namespace

BlockJob::BlockJob(BuildShared& shared, const Stage& stage, const StageStores& stores, Pass pass,
                   std::unique_ptr<NodeSource> source)
    : shared_(shared), stage_(stage), stores_(stores), pass_(pass), source_(std::move(source)),
      maker_(shared),
      windows_(std::size_t(stage.finest - stage.coarsest + 1 + (stage.feedsNext ? 1 : 0))),
      tiles_(std::size_t(stage.finest - stage.coarsest + 1)) {}

Status BlockJob::run(TileId block) {
  Stopwatch watch;
  prepareWindows(block);
  QMESH_RETURN_IF_ERROR(loadFinest());
  maker_.seconds()[int(Step::sample)] += watch.lap();
  reduceAll();
  maker_.seconds()[int(Step::reduce)] += watch.lap();
  if (pass_ != Pass::down) {
    registerTiles();
    QMESH_RETURN_IF_ERROR(storeAll(block));
  }
  if (pass_ != Pass::up) {
    QMESH_RETURN_IF_ERROR(fillAll(block));
    if (pass_ == Pass::down)
      QMESH_RETURN_IF_ERROR(storeAll(block));
    QMESH_RETURN_IF_ERROR(meshAll());
  }
  maker_.publish();
  return {};
}

void BlockJob::prepareWindows(TileId block) {
  const PyramidPlan& plan = shared_.plan;
  const TileRange box = coarsestTiles(plan, stage_, block);
  for (int z = stage_.finest; z >= stage_.coarsest; --z) {
    const int down = z - stage_.coarsest;
    const TileRange tiles{box.x0 << down, box.y0 << down, (box.x1 << down) | ((1u << down) - 1),
                          (box.y1 << down) | ((1u << down) - 1)};
    const int halo = haloForLevels(shared_.options.overviewResampling, down);
    windowOf(z).reset(plan.lattice(z), tiles, halo);
  }
  if (stage_.feedsNext) {
    windows_.back().reset(plan.lattice(block.z), {block.x, block.y, block.x, block.y}, 0);
  }
  for (int z = stage_.finest; z >= stage_.coarsest; --z) {
    auto& tiles = tiles_[std::size_t(stage_.finest - z)];
    tiles.clear();
    for (const TileRange& r : plan.tiles.rangesUnder(block, z)) {
      for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
        for (std::uint32_t x = r.x0; x <= r.x1; ++x)
          tiles.push_back({z, x, y});
      }
    }
  }
}

Status BlockJob::sampleRange(const TileRange& range, std::int64_t columnShift) {
  NodeWindow& window = windows_.front();
  const std::int64_t n = window.lattice().cells();
  const std::int64_t i0 = std::max(range.x0 * n + columnShift, window.column0());
  const std::int64_t i1 =
      std::min((range.x1 + 1) * n + columnShift, window.column0() + window.width() - 1);
  const std::int64_t j0 = std::max(range.y0 * n, window.row0());
  const std::int64_t j1 = std::min((range.y1 + 1) * n, window.row0() + window.height() - 1);
  if (i0 > i1 || j0 > j1)
    return {};
  return source_->sample(i0, j0, int(i1 - i0 + 1), int(j1 - j0 + 1),
                         window.row(int(j0 - window.row0())) + (i0 - window.column0()),
                         window.stride());
}

/// Nodes are taken from the closed squares of planned tiles only: what lies beyond (rims of the
/// extent's estimate, tiles the user left out) is void for every block alike.
Status BlockJob::loadFinest() {
  NodeWindow& window = windows_.front();
  if (stores_.raw) {
    QMESH_RETURN_IF_ERROR(stores_.raw->read(window));
  } else {
    const std::int64_t columns = window.lattice().columns();
    for (const TileRange& range : shared_.plan.dataTiles) {
      for (const std::int64_t shift : {-columns, std::int64_t(0), columns}) {
        QMESH_RETURN_IF_ERROR(sampleRange(range, shift));
      }
    }
  }
  window.setPoles(shared_.source.poleHeight(false), shared_.source.poleHeight(true));
  if (!shared_.anyData && window.anyHeight())
    shared_.anyData = true;
  return {};
}

void BlockJob::reduceAll() {
  for (std::size_t k = 1; k < windows_.size(); ++k) {
    reduceWindow(windows_[k - 1], shared_.options.overviewResampling, windows_[k]);
    windows_[k].setPoles(shared_.source.poleHeight(false), shared_.source.poleHeight(true));
  }
}

/// With -x a tile without data is left out, unless one below it is kept: levels must not have gaps.
bool BlockJob::keepsTile(TileId id, const NodeWindow& window) const {
  if (!shared_.options.excludeVoid || id.z == 0 || !window.isVoid(id))
    return true;
  for (std::uint32_t k = 0; k < 4; ++k) {
    if (shared_.written.contains({id.z + 1, 2 * id.x + (k & 1), 2 * id.y + (k >> 1)}))
      return true;
  }
  return false;
}

void BlockJob::registerTiles() {
  const std::lock_guard<std::mutex> lock(shared_.mutex);
  for (std::size_t k = 0; k < tiles_.size(); ++k) {
    for (const TileId id : tiles_[k]) {
      if (keepsTile(id, windows_[k]))
        shared_.written.add(id);
    }
  }
}

Status BlockJob::fillAll(TileId block) {
  const float value = float(shared_.options.voidValue);
  if (pass_ == Pass::whole) {
    for (std::size_t k = 0; k < tiles_.size(); ++k)
      fillVoids(windows_[k], value);
    return {};
  }
  if (stage_.feedsNext) {
    const PyramidPlan& plan = shared_.plan;
    context_.reset(plan.lattice(block.z), {block.x, block.y, block.x, block.y}, kTileHalo);
    QMESH_RETURN_IF_ERROR(stores_.filledCoarse->read(context_));
    fillVoids(context_, value);
  }
  for (std::size_t k = tiles_.size(); k-- > 0;) {
    fillVoidsOutside(windows_[k], shared_.plan.support, value);
    if (k + 1 < tiles_.size()) {
      fillVoids(windows_[k], windows_[k + 1]);
    } else if (stage_.feedsNext) {
      fillVoids(windows_[k], context_);
    } else {
      fillVoids(windows_[k], value);
    }
  }
  return {};
}

Status BlockJob::meshAll() {
  for (std::size_t k = 0; k < tiles_.size(); ++k) {
    for (const TileId id : tiles_[k]) {
      if (shared_.stop)
        return {};
      QMESH_RETURN_IF_ERROR(maker_.make(windows_[k].tile(id)));
    }
  }
  return {};
}

Status BlockJob::storeAll(TileId block) {
  if (pass_ == Pass::down)
    return stores_.filled ? storeTiles(block, windows_.front(), *stores_.filled) : Status();
  if (stores_.levels)
    return storeLevels(block);
  return stage_.feedsNext ? stores_.rawCoarse->put(windows_.back(), block) : Status();
}

/// The block's tiles of the window's level.
Status BlockJob::storeTiles(TileId block, const NodeWindow& window, ChunkStore& store) {
  const int zoom = window.lattice().zoom();
  for (const TileRange& r : shared_.plan.support.rangesUnder(block, zoom)) {
    for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
      for (std::uint32_t x = r.x0; x <= r.x1; ++x)
        QMESH_RETURN_IF_ERROR(store.put(window, {zoom, x, y}));
    }
  }
  return {};
}

Status BlockJob::storeLevels(TileId block) {
  for (std::size_t k = stores_.raw ? 1 : 0; k < windows_.size(); ++k) {
    const NodeWindow& window = windows_[k];
    const auto zoom = std::size_t(window.lattice().zoom());
    QMESH_RETURN_IF_ERROR(storeTiles(block, window, *(*stores_.levels)[zoom]));
  }
  return {};
}

} // namespace qmesh
