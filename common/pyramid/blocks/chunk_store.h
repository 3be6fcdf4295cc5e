// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/status.h"
#include "grid/node_window.h"

namespace qmesh {

/// Bytes that all stores of a run may still hold in memory.
using MemoryBudget = std::atomic<std::int64_t>;

/// The raster of one level between two stages, in chunks: the (N+1)^2 nodes of a tile, edges
/// included, because the tile next door may not exist. Held in memory while the budget lasts, then
/// compressed in one temporary file. Many threads may put at once, or read at once.
class ChunkStore {
 public:
  /// `spillFile` is created only when the budget runs out, and removed with the store.
  ChunkStore(const NodeLattice& lattice, MemoryBudget& budget, std::string spillFile);
  ~ChunkStore();
  ChunkStore(const ChunkStore&) = delete;
  ChunkStore& operator=(const ChunkStore&) = delete;

  /// Stores the tile's nodes from a window of that level that holds them. All-void chunks take no
  /// room.
  Status put(const NodeWindow& window, TileId tile);

  /// Fills every node of the window (of the same level) that a stored chunk holds.
  Status read(NodeWindow& window) const;

 private:
  struct Chunk {
    std::vector<float> nodes; ///< empty: spilled
    std::uint64_t offset = 0;
    std::uint32_t size = 0; ///< bytes in the spill file
  };

  std::size_t chunkNodes() const;
  Status spill(const std::vector<float>& nodes, Chunk& chunk);
  Status load(const Chunk& chunk, std::vector<float>& nodes) const;
  Status openSpillFile();

  NodeLattice lattice_;
  MemoryBudget& budget_;
  std::string spillFile_;
  int file_ = -1;
  std::uint64_t fileSize_ = 0;
  mutable std::mutex mutex_;
  std::unordered_map<std::uint64_t, Chunk> chunks_; ///< by y << 32 | x
};

} // namespace qmesh
