// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "pyramid/build_shared.h"
#include "pyramid/tile_job.h"

namespace qmesh {

/// One thread's way from height tiles to files and statistics, the same for every border mode.
class TileMaker {
 public:
  explicit TileMaker(BuildShared& shared);

  /// Makes and writes one of the plan's tiles, unless -x leaves it out.
  Status make(const HeightTile& tile) { return make(tile, nullptr); }
  /// The same under --border inherit, see TileJob::run().
  Status make(const HeightTile& tile, Border& border) { return make(tile, &border); }

  /// Time spent by this thread since the last publish(), for the caller to add to.
  StepSeconds& seconds() { return seconds_; }

  /// Adds this thread's sums to the shared ones.
  void publish();

 private:
  Status make(const HeightTile& tile, Border* border);

  BuildShared& shared_;
  TileJob job_;
  TileResult result_;
  std::vector<LevelStats> levels_;
  StepSeconds seconds_{};
  std::uint64_t contentHash_ = 0;
};

} // namespace qmesh
