// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <cstdint>
#include <vector>

namespace qmesh {

/// Node (i, j) of a tile of N cells as j (N + 1) + i.
using NodeIndex = std::int32_t;

/// The nodes of one tile by number.
class NodeGrid {
 public:
  explicit NodeGrid(int cells) : cells_(cells) {}

  int cells() const { return cells_; }
  std::size_t size() const { return std::size_t(cells_ + 1) * std::size_t(cells_ + 1); }
  NodeIndex index(int i, int j) const { return j * (cells_ + 1) + i; }
  int column(NodeIndex node) const { return node % (cells_ + 1); }
  int row(NodeIndex node) const { return node / (cells_ + 1); }
  bool isInner(NodeIndex node) const {
    const int i = column(node), j = row(node);
    return i > 0 && j > 0 && i < cells_ && j < cells_;
  }

 private:
  int cells_;
};

/// A line from node to node, at least two; a closed one ends with its first.
using NodeLine = std::vector<NodeIndex>;

} // namespace qmesh
