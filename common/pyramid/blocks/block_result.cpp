// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/block_result.h"

#include <algorithm>

namespace qmesh {

void BlockResult::addTile(int zoom, const LevelStats& stats, std::uint64_t fingerprint) {
  levels.resize(std::max(levels.size(), std::size_t(zoom) + 1));
  levels[std::size_t(zoom)].add(stats);
  contentHash += fingerprint;
}

void BlockResult::add(const BlockResult& other) {
  kept.add(other.kept);
  levels.resize(std::max(levels.size(), other.levels.size()));
  for (std::size_t z = 0; z < other.levels.size(); ++z)
    levels[z].add(other.levels[z]);
  for (std::size_t k = 0; k < seconds.size(); ++k)
    seconds[k] += other.seconds[k];
  contentHash += other.contentHash;
  anyData = anyData || other.anyData;
}

void RunTotals::add(const BlockResult& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  total_.add(result);
}

BlockResult RunTotals::get() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return total_;
}

} // namespace qmesh
