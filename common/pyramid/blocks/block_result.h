// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "pyramid/report.h"
#include "tiling/availability.h"

namespace qmesh {

/// What a block has made, beside the tiles and nodes it stored. A value: the results of all blocks,
/// added in any order, are the result of the run.
struct BlockResult {
  Availability kept;              ///< tiles of the tileset, found by the upward pass
  std::vector<LevelStats> levels; ///< of the tiles written, by zoom from 0; may end early
  StepSeconds seconds{};          ///< time spent, for the report; the only part that varies
  std::uint64_t contentHash = 0;  ///< sum of the fingerprints of the tiles written
  bool anyData = false;           ///< a node of its finest level has a height

  /// Counts one written tile.
  void addTile(int zoom, const LevelStats& stats, std::uint64_t fingerprint);
  void add(const BlockResult& other);
};

/// The merged results of a run; threads may add at once.
class RunTotals {
 public:
  void add(const BlockResult& result);
  /// A copy of what has been added so far.
  BlockResult get() const;

 private:
  mutable std::mutex mutex_; ///< guards total_
  BlockResult total_;
};

} // namespace qmesh
