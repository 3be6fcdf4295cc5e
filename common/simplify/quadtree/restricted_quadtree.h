// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

namespace qmesh {

/// A square of nodes: its south-west corner and how many cells it is wide, a power of two.
struct QuadCell {
  int i = 0;
  int j = 0;
  int size = 1;
};

/// Restricted quadtree over the N x N cells of a tile (von Herzen & Barr 1987): leaves that share a
/// piece of a side are of one size, or one is twice as wide as the other.
class RestrictedQuadtree {
 public:
  /// Begins with `baseGrid` x `baseGrid` leaves; both powers of two, baseGrid <= cells.
  void reset(int cells, int baseGrid);

  int cells() const { return cells_; }

  /// Width of the leaf that holds the cell whose south-west node is (i, j), 0..N-1 each.
  int leafSize(int i, int j) const { return size_[std::size_t(j * cells_ + i)]; }
  QuadCell leafAt(int i, int j) const {
    const int size = leafSize(i, j);
    return {i / size * size, j / size * size, size};
  }

  /// Divides the leaf that holds a cell, and before it every neighbour twice as wide.
  /// REQUIRES: leafSize(i, j) > 1.
  void divide(int i, int j);

  /// Calls visit(QuadCell) for every leaf, by rows of the base grid, within by quarters.
  template <class Visit> void forEachLeaf(Visit visit) const {
    for (int j = 0; j < cells_; j += base_) {
      for (int i = 0; i < cells_; i += base_)
        visitLeaves({i, j, base_}, visit);
    }
  }

 private:
  template <class Visit> void visitLeaves(const QuadCell& cell, Visit& visit) const {
    if (leafSize(cell.i, cell.j) == cell.size) {
      visit(cell);
      return;
    }
    const int half = cell.size / 2;
    for (const int dj : {0, half}) {
      for (const int di : {0, half})
        visitLeaves({cell.i + di, cell.j + dj, half}, visit);
    }
  }

  int cells_ = 0;
  int base_ = 0;
  std::vector<std::uint16_t> size_; ///< by cell: of its leaf
};

} // namespace qmesh
