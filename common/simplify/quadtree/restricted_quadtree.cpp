// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/quadtree/restricted_quadtree.h"

#include <algorithm>
#include <cassert>

namespace qmesh {

void RestrictedQuadtree::reset(int cells, int baseGrid) {
  cells_ = cells;
  base_ = cells / baseGrid;
  size_.assign(std::size_t(cells) * std::size_t(cells), std::uint16_t(base_));
}

void RestrictedQuadtree::divide(int i, int j) {
  const QuadCell leaf = leafAt(i, j);
  assert(leaf.size > 1);
  const int beyond[4][2] = {{leaf.i - 1, leaf.j},
                            {leaf.i, leaf.j - 1},
                            {leaf.i + leaf.size, leaf.j},
                            {leaf.i, leaf.j + leaf.size}};
  for (const auto& [ni, nj] : beyond) {
    const bool exists = ni >= 0 && nj >= 0 && ni < cells_ && nj < cells_;
    if (exists && leafSize(ni, nj) > leaf.size)
      divide(ni, nj);
  }
  const auto half = std::uint16_t(leaf.size / 2);
  for (int row = leaf.j; row < leaf.j + leaf.size; ++row) {
    std::uint16_t* first = size_.data() + row * cells_ + leaf.i;
    std::fill(first, first + leaf.size, half);
  }
}

} // namespace qmesh
