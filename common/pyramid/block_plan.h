// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <vector>

#include "base/status.h"
#include "pyramid/pyramid_plan.h"
#include "pyramid/run_options.h"

namespace qmesh {

/// One pass over blocks. A block is the subtree of a tile of `blockZoom`: it takes its nodes of
/// level `finest`, meshes its tiles of finest..coarsest, reducing 2:1 between levels, and, where
/// another stage follows, stores its own nodes of `blockZoom` for it.
struct Stage {
  int finest = 0;
  int coarsest = 0;
  int blockZoom = 0;
  bool feedsNext = false;     ///< the next stage's finest level is blockZoom
  std::vector<TileId> blocks; ///< tiles of blockZoom, north to south, west to east
};

/// How the work is cut: none of it can change a value of the result.
struct BlockPlan {
  int blockTiles = 8; ///< tiles of the finest level along a block's edge, 2, 4 or 8
  int threads = 1;
  std::size_t cacheBytes = 0; ///< for the reader's block cache
  std::size_t storeBytes = 0; ///< for stage rasters held in memory; the rest goes to disk
  std::vector<Stage> stages;  ///< finest first
};

/// The stages for blocks of 2^depth tiles a side, down to level `lastZoom`.
std::vector<Stage> planStages(const PyramidPlan& plan, int depth, int lastZoom);

/// Fits block size and threads into --memory: full blocks and all threads if they fit and every
/// thread gets several, else smaller blocks, else fewer threads. Code::usage naming the minimum
/// where not even one thread with the smallest blocks fits.
Result<BlockPlan> planBlocks(const TilesetOptions& options, const RunOptions& run,
                             const PyramidPlan& plan, std::size_t bytesPerSource, int processors);

/// The level down to which values are needed: --void-fill interpolate bridges holes from level 0.
int lastZoomNeeded(const HeightOptions& options, const PyramidPlan& plan);

} // namespace qmesh
