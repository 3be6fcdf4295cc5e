// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pyramid/blocks/block_job.h"
#include "pyramid/blocks/block_windows.h"
#include "pyramid/tile_maker.h"

namespace qmesh {

/// The stores that take the nodes of a block, by zoom; null where nobody needs that level.
using NodeStores = std::vector<ChunkStore*>;

/// What an upward job does with its tiles.
enum class TileMaking {
  none,         ///< decides which there are; a later pass makes them
  constantFill, ///< fills voids with the constant and makes them
};

/// From the finest level of a stage to the coarsest: loads, reduces, decides which tiles the
/// tileset has, and stores nodes for later. With a constant void fill that is enough to make the
/// tiles, too.
class UpwardJob : public BlockJob {
 public:
  /// `finer`: the tiles of all levels beyond the stage's finest. It, the stage and the stores
  /// outlive the job.
  UpwardJob(const RunContext& context, const Stage& stage, const Availability& finer,
            std::unique_ptr<FinestNodes> finest, NodeStores stores, TileMaking making);

  Result<BlockResult> run(TileId block) override;

 private:
  void keepTiles(BlockResult& result);
  Status storeLevels(TileId block);
  Status makeTiles(BlockResult& result);

  const RunContext& context_;
  const Stage& stage_;
  const Availability& finer_;
  NodeStores stores_;
  BlockWindows windows_;
  std::optional<TileMaker> maker_; ///< none: tiles are made by a later pass
};

} // namespace qmesh
