// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "pyramid/blocks/block_result.h"
#include "pyramid/blocks/block_windows.h"
#include "pyramid/run_context.h"
#include "pyramid/tile_job.h"

namespace qmesh {

/// One thread's way from height tiles to stored tiles and their statistics, the same for every
/// border mode.
class TileMaker {
 public:
  explicit TileMaker(const RunContext& context)
      : context_(context), job_(context.options().method, context.options().output) {}

  /// Makes and stores one of the plan's tiles, unless it is not kept. Adds to `result`.
  Status make(const HeightTile& tile, const KeptTiles& kept, BlockResult& result) {
    return make(tile, kept, nullptr, result);
  }
  /// The same under --border inherit, see TileJob::run().
  Status make(const HeightTile& tile, const KeptTiles& kept, Border& border, BlockResult& result) {
    return make(tile, kept, &border, result);
  }

  /// Every tile of a block, finest level first; ends early when the run is stopped.
  Status makeBlock(BlockWindows& windows, const KeptTiles& kept, BlockResult& result);

 private:
  Status make(const HeightTile& tile, const KeptTiles& kept, Border* border, BlockResult& result);

  const RunContext& context_;
  TileJob job_;
  TileResult tile_;
};

} // namespace qmesh
