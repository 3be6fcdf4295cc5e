// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/qem/vertex_heap.h"

#include <utility>

namespace qmesh {

void VertexHeap::reset(std::vector<std::uint32_t> ranks) {
  heap_.clear();
  position_.assign(ranks.size(), -1);
  cost_.assign(ranks.size(), 0);
  rank_ = std::move(ranks);
}

void VertexHeap::set(std::int32_t vertex, double cost) {
  cost_[std::size_t(vertex)] = cost;
  if (position_[std::size_t(vertex)] < 0) {
    heap_.push_back(vertex);
    position_[std::size_t(vertex)] = std::int32_t(heap_.size()) - 1;
  }
  siftUp(std::size_t(position_[std::size_t(vertex)]));
  siftDown(std::size_t(position_[std::size_t(vertex)]));
}

void VertexHeap::remove(std::int32_t vertex) {
  const std::int32_t at = position_[std::size_t(vertex)];
  if (at < 0)
    return;
  const std::int32_t last = heap_.back();
  heap_.pop_back();
  position_[std::size_t(vertex)] = -1;
  if (last == vertex)
    return;
  place(std::size_t(at), last);
  siftUp(std::size_t(at));
  siftDown(std::size_t(position_[std::size_t(last)]));
}

void VertexHeap::place(std::size_t at, std::int32_t vertex) {
  heap_[at] = vertex;
  position_[std::size_t(vertex)] = std::int32_t(at);
}

void VertexHeap::siftUp(std::size_t at) {
  const std::int32_t vertex = heap_[at];
  while (at > 0 && before(vertex, heap_[(at - 1) / 2])) {
    place(at, heap_[(at - 1) / 2]);
    at = (at - 1) / 2;
  }
  place(at, vertex);
}

void VertexHeap::siftDown(std::size_t at) {
  const std::int32_t vertex = heap_[at];
  while (2 * at + 1 < heap_.size()) {
    std::size_t child = 2 * at + 1;
    if (child + 1 < heap_.size() && before(heap_[child + 1], heap_[child]))
      ++child;
    if (!before(heap_[child], vertex))
      break;
    place(at, heap_[child]);
    at = child;
  }
  place(at, vertex);
}

} // namespace qmesh
