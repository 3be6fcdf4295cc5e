// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/inherit/tile_queue.h"

#include <chrono>

namespace qmesh {

namespace {

/// How often a waiting thread looks whether the run is stopped.
constexpr std::chrono::milliseconds kStopInterval(50);

} // namespace

TileQueue::TileQueue(const TileSchedule& schedule)
    : schedule_(schedule), missing_(schedule.count()), left_(schedule.count()) {
  for (std::uint32_t k = 0; k < schedule.count(); ++k) {
    missing_[k] = std::uint8_t(schedule.earlierNeighbours(k));
    if (missing_[k] == 0)
      ready_.push(k);
  }
}

std::optional<std::uint32_t> TileQueue::next(const std::atomic<bool>& stop) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (left_ > 0 && ready_.empty() && !stop)
    changed_.wait_for(lock, kStopInterval);
  if (left_ == 0 || stop)
    return std::nullopt;
  const std::uint32_t index = ready_.top();
  ready_.pop();
  if (--left_ == 0)
    changed_.notify_all();
  return index;
}

void TileQueue::finish(std::uint32_t index) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& neighbour : schedule_.neighbours(index)) {
    const bool waits = neighbour && schedule_.rank(*neighbour) > schedule_.rank(index);
    if (waits && --missing_[*neighbour] == 0) {
      ready_.push(*neighbour);
      changed_.notify_one();
    }
  }
}

} // namespace qmesh
