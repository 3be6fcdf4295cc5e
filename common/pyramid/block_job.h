// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <vector>

#include "base/status.h"
#include "pyramid/block_plan.h"
#include "pyramid/chunk_store.h"
#include "pyramid/tile_maker.h"

namespace qmesh {

/// What a pass over a stage's blocks does. With a constant void fill one pass does all; bridging
/// voids takes two: up, to the coarsest level, and down again with the coarser level at hand.
enum class Pass { whole, up, down };

/// The rasters a stage reads and feeds; null where there is none.
struct StageStores {
  const ChunkStore* raw = nullptr;          ///< nodes of level `finest`; null: sample the input
  ChunkStore* rawCoarse = nullptr;          ///< takes nodes of level `blockZoom` (whole, up)
  const ChunkStore* filledCoarse = nullptr; ///< level `blockZoom` without voids (down)
  ChunkStore* filled = nullptr;             ///< takes level `finest` without voids (down)
  /// Takes the tiles of every level by zoom, but of those that were read from `raw` (up); null:
  /// none.
  const std::vector<std::unique_ptr<ChunkStore>>* levels = nullptr;
};

/// Runs the blocks of one stage for one thread; buffers are reused from block to block.
class BlockJob {
 public:
  /// `source` is null where the stage reads from a store.
  BlockJob(BuildShared& shared, const Stage& stage, const StageStores& stores, Pass pass,
           std::unique_ptr<NodeSource> source);

  /// Does one block. Stops early, without an error, when `shared.stop` is set.
  Status run(TileId block);

 private:
  void prepareWindows(TileId block);
  Status loadFinest();
  Status sampleRange(const TileRange& range, std::int64_t columnShift);
  void reduceAll();
  void registerTiles();
  Status fillAll(TileId block);
  Status meshAll();
  Status storeAll(TileId block);
  Status storeTiles(TileId block, const NodeWindow& window, ChunkStore& store);
  Status storeLevels(TileId block);

  NodeWindow& windowOf(int zoom) { return windows_[std::size_t(stage_.finest - zoom)]; }
  bool keepsTile(TileId id, const NodeWindow& window) const;

  BuildShared& shared_;
  const Stage& stage_;
  StageStores stores_;
  Pass pass_;
  std::unique_ptr<NodeSource> source_;
  TileMaker maker_;
  std::vector<NodeWindow> windows_;        ///< finest..coarsest, then blockZoom where it is stored
  std::vector<std::vector<TileId>> tiles_; ///< to mesh: finest..coarsest
  NodeWindow context_;                     ///< blockZoom without voids (down)
};

} // namespace qmesh
