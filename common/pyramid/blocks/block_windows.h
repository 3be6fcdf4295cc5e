// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "pyramid/block_plan.h"
#include "pyramid/blocks/finest_nodes.h"
#include "pyramid/report.h"

namespace qmesh {

/// The nodes of one block, a window for each level of its stage, halo included; buffers are reused
/// from block to block.
class BlockWindows {
 public:
  BlockWindows(const TilesetInput& input, const Stage& stage, std::unique_ptr<FinestNodes> finest);

  /// Takes the nodes of the finest level and reduces them level by level. Adds to `seconds`.
  Status load(TileId block, StepSeconds& seconds);

  /// A node of the finest level has a height.
  bool anyData() const { return windows_.front().anyHeight(); }

  /// The planned tiles of this block and their level's window, finest level first.
  struct Level {
    const std::vector<TileId>& tiles;
    NodeWindow& window;
  };
  std::size_t levelCount() const { return tiles_.size(); }
  Level level(std::size_t k) { return {tiles_[k], windows_[k]}; }

  /// All windows: those of the levels, then where another stage follows that of its finest level,
  /// without a halo.
  const std::vector<NodeWindow>& windows() const { return windows_; }

 private:
  void prepare(TileId block);
  void reduceAll();

  const TilesetInput& input_;
  const Stage& stage_;
  std::unique_ptr<FinestNodes> finest_;
  std::vector<NodeWindow> windows_;
  std::vector<std::vector<TileId>> tiles_;
};

/// Stores the tiles below `block` of the window's level, those where nodes have a meaning.
Status storeNodes(const PyramidPlan& plan, TileId block, const NodeWindow& window,
                  ChunkStore& store);

} // namespace qmesh
