// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/status.h"
#include "pyramid/blocks/block_result.h"

namespace qmesh {

/// Runs the blocks of one stage for one thread. What comes out of a block - its result, the tiles
/// in the sink, the nodes it stores - is a function of the block and of what earlier stages have
/// stored; running it again gives the same.
class BlockJob {
 public:
  virtual ~BlockJob() = default;

  /// Does one block. Ends early, without an error, when the run is stopped: the result is
  /// incomplete then, and the caller drops it.
  virtual Result<BlockResult> run(TileId block) = 0;
};

} // namespace qmesh
