// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "base/status.h"
#include "build/block_plan.h"
#include "build/chunk_store.h"
#include "build/tile_job.h"
#include "build/tile_sink.h"

namespace qmesh {

/// What a pass over a stage's blocks does. With a constant void fill one pass does all; bridging
/// voids takes two: up, to the coarsest level, and down again with the coarser level at hand.
enum class Pass { whole, up, down };

/// What the blocks of a run share. Plans and options are const; the rest guards itself.
struct BuildShared {
  BuildShared(const TilesetInput& input, TileSink& theSink)
      : options(input.options), plan(input.plan), source(input.source), sink(theSink),
        levels(input.plan.levels.size()) {}

  const BuildOptions& options;
  const PyramidPlan& plan;
  const NodeSourceFactory& source;
  TileSink& sink;

  std::mutex mutex; ///< guards what follows
  Availability written;
  std::vector<LevelStats> levels;
  StepSeconds seconds{};
  std::uint64_t contentHash = 0;

  std::atomic<bool> anyData{false}; ///< a node of the finest level has a height
  std::atomic<std::uint64_t> tilesDone{0};
  std::atomic<bool> stop{false};
};

/// The rasters a stage reads and feeds; null where there is none.
struct StageStores {
  const ChunkStore* raw = nullptr;          ///< nodes of level `finest`; null: sample the input
  ChunkStore* rawCoarse = nullptr;          ///< takes nodes of level `blockZoom` (whole, up)
  const ChunkStore* filledCoarse = nullptr; ///< level `blockZoom` without voids (down)
  ChunkStore* filled = nullptr;             ///< takes level `finest` without voids (down)
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
  Status meshTile(TileId id, NodeWindow& window);
  Status storeAll(TileId block);
  void publish();

  NodeWindow& windowOf(int zoom) { return windows_[std::size_t(stage_.finest - zoom)]; }
  bool keepsTile(TileId id, const NodeWindow& window) const;

  BuildShared& shared_;
  const Stage& stage_;
  StageStores stores_;
  Pass pass_;
  std::unique_ptr<NodeSource> source_;
  TileJob tileJob_;
  TileResult result_;
  std::vector<NodeWindow> windows_;        ///< finest..coarsest, then blockZoom where it is stored
  std::vector<std::vector<TileId>> tiles_; ///< to mesh: finest..coarsest
  NodeWindow context_;                     ///< blockZoom without voids (down)
  std::vector<LevelStats> levels_;
  StepSeconds seconds_{};
  std::uint64_t contentHash_ = 0;
};

} // namespace qmesh
