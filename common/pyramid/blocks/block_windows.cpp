// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/block_windows.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "grid/reduce.h"

namespace qmesh {

namespace {

/// The smallest rectangle of tiles of the stage's coarsest level around the block's planned tiles
/// of all levels. Each level's window is this one times a power of two, so that a coarse node's
/// stencil lies in the finer window wherever there can be data.
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

BlockWindows::BlockWindows(const TilesetInput& input, const Stage& stage,
                           std::unique_ptr<FinestNodes> finest)
    : input_(input), stage_(stage), finest_(std::move(finest)),
      windows_(std::size_t(stage.finest - stage.coarsest + 1 + (stage.feedsNext ? 1 : 0))),
      tiles_(std::size_t(stage.finest - stage.coarsest + 1)) {}

Status BlockWindows::load(TileId block, StepSeconds& seconds) {
  Stopwatch watch;
  prepare(block);
  NodeWindow& finest = windows_.front();
  QMESH_RETURN_IF_ERROR(finest_->load(finest));
  finest.setPoles(input_.source.poleHeight(false), input_.source.poleHeight(true));
  seconds[int(Step::sample)] += watch.lap();
  reduceAll();
  seconds[int(Step::reduce)] += watch.lap();
  return {};
}

void BlockWindows::prepare(TileId block) {
  const PyramidPlan& plan = input_.plan;
  const TileRange box = coarsestTiles(plan, stage_, block);
  for (std::size_t k = 0; k < tiles_.size(); ++k) {
    const int zoom = stage_.finest - int(k);
    const int down = zoom - stage_.coarsest;
    const TileRange tiles{box.x0 << down, box.y0 << down, (box.x1 << down) | ((1u << down) - 1),
                          (box.y1 << down) | ((1u << down) - 1)};
    windows_[k].reset(plan.lattice(zoom), tiles,
                      haloForLevels(input_.options.tiling.overviewResampling, down));
    tiles_[k].clear();
    for (const TileRange& r : plan.tiles.rangesUnder(block, zoom))
      for (std::uint32_t y = r.y0; y <= r.y1; ++y)
        for (std::uint32_t x = r.x0; x <= r.x1; ++x)
          tiles_[k].push_back({zoom, x, y});
  }
  if (stage_.feedsNext)
    windows_.back().reset(plan.lattice(block.z), {block.x, block.y, block.x, block.y}, 0);
}

void BlockWindows::reduceAll() {
  for (std::size_t k = 1; k < windows_.size(); ++k) {
    reduceWindow(windows_[k - 1], input_.options.tiling.overviewResampling, windows_[k]);
    windows_[k].setPoles(input_.source.poleHeight(false), input_.source.poleHeight(true));
  }
}

Status storeNodes(const PyramidPlan& plan, TileId block, const NodeWindow& window,
                  ChunkStore& store) {
  const int zoom = window.lattice().zoom();
  for (const TileRange& r : plan.support.rangesUnder(block, zoom))
    for (std::uint32_t y = r.y0; y <= r.y1; ++y)
      for (std::uint32_t x = r.x0; x <= r.x1; ++x)
        QMESH_RETURN_IF_ERROR(store.put(window, {zoom, x, y}));
  return {};
}

} // namespace qmesh
