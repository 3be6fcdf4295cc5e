// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <queue>
#include <vector>

#include "pyramid/inherit/schedule.h"

namespace qmesh {

/// Hands the tiles of a schedule to threads: a tile when the neighbours before it are done, of
/// those that may the first one row by row, so that the front of the work stays short whatever the
/// schedule.
class TileQueue {
 public:
  explicit TileQueue(const TileSchedule& schedule);

  /// The next tile; waits for one where all that are left wait themselves. None when all are taken,
  /// or `stop` is set.
  std::optional<std::uint32_t> next(const std::atomic<bool>& stop);

  /// Tells that a tile is done.
  void finish(std::uint32_t index);

 private:
  using Indices = std::vector<std::uint32_t>;

  const TileSchedule& schedule_;
  std::mutex mutex_; ///< guards what follows
  std::condition_variable changed_;
  std::vector<std::uint8_t> missing_; ///< earlier neighbours that are not done
  std::priority_queue<std::uint32_t, Indices, std::greater<std::uint32_t>> ready_;
  std::uint32_t left_; ///< not taken
};

} // namespace qmesh
