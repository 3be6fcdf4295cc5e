// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

namespace qmesh {

/// Binary heap of vertices by cost, smallest first, then by rank: its order does not depend on how
/// it came to be. A vertex is in it once at most and can change its cost.
class VertexHeap {
 public:
  /// Empty, for vertices 0..ranks.size()-1; REQUIRES: no two ranks are the same.
  void reset(std::vector<std::uint32_t> ranks);

  bool empty() const { return heap_.empty(); }
  bool contains(std::int32_t vertex) const { return position_[std::size_t(vertex)] >= 0; }
  std::int32_t top() const { return heap_.front(); }
  std::uint32_t rank(std::int32_t vertex) const { return rank_[std::size_t(vertex)]; }
  double cost(std::int32_t vertex) const { return cost_[std::size_t(vertex)]; }

  /// Puts a vertex in or gives it another cost.
  void set(std::int32_t vertex, double cost);
  /// Takes a vertex out; one that is not in stays out.
  void remove(std::int32_t vertex);

 private:
  bool before(std::int32_t a, std::int32_t b) const {
    const double costA = cost(a), costB = cost(b);
    return costA != costB ? costA < costB : rank(a) < rank(b);
  }
  void place(std::size_t at, std::int32_t vertex);
  void siftUp(std::size_t at);
  void siftDown(std::size_t at);

  std::vector<std::int32_t> heap_;
  std::vector<std::int32_t> position_; ///< in heap_ by vertex, -1: not in
  std::vector<double> cost_;
  std::vector<std::uint32_t> rank_;
};

} // namespace qmesh
