// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "pyramid/block_plan.h"

namespace qmesh {

/// What a run is likely to make and take.
struct Estimate {
  std::vector<std::uint64_t> bytes; ///< by zoom from 0
  double seconds = 0;               ///< with the threads of the block plan

  std::uint64_t totalBytes() const;
};

/// Estimates by making a few tiles of the finest zooms, spread over the data, without writing
/// them; coarser zooms count like the coarsest one tried. Half or twice the truth is to be expected
/// where the terrain differs from place to place.
Result<Estimate> estimateRun(const TilesetInput& input, const BlockPlan& blocks);

} // namespace qmesh
