// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>

#include "pyramid/blocks/block_job.h"
#include "pyramid/blocks/block_windows.h"
#include "pyramid/tile_maker.h"

namespace qmesh {

/// The second pass of --void-fill interpolate, from the coarsest level to the finest: voids get
/// heights from the filled level above, and the tiles are made.
class DownwardJob : public BlockJob {
 public:
  /// The filled nodes that a stage reads and leaves.
  struct Stores {
    const ChunkStore* above = nullptr; ///< level `blockZoom`; null for the stage with level 0
    ChunkStore* finest = nullptr;      ///< takes level `finest`; null for the first stage
  };

  /// `kept`: every tile of the tileset. It, the stage and the stores outlive the job.
  DownwardJob(const RunContext& context, const Stage& stage, const KeptTiles& kept,
              std::unique_ptr<FinestNodes> finest, const Stores& stores);

  Result<BlockResult> run(TileId block) override;

 private:
  Status fillAll(TileId block);

  const RunContext& context_;
  const KeptTiles& kept_;
  Stores stores_;
  BlockWindows windows_;
  NodeWindow above_; ///< level `blockZoom` without voids
  TileMaker maker_;
};

} // namespace qmesh
