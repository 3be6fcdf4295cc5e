// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "grid/height_tile.h"

namespace qmesh {

/// How much the slope changes around the nodes of a tile (Cifuentes, Venere & Clausse, "Interactive
/// remeshing for navigation over landscape models"):
///
///   kappa^2 = (Gx[i+1,j] - Gx[i-1,j])^2 + (Gy[i+1,j] - Gy[i-1,j])^2
///           + (Gx[i,j+1] - Gx[i,j-1])^2 + (Gy[i,j+1] - Gy[i,j-1])^2
///
/// with the gradients Gx, Gy by central differences in metres of the node's own latitude: no unit.
/// At the ends of the lattice, where a row does not exist, the last one stands for it. The same
/// bits from both tiles that share a node.
class Curvature {
 public:
  /// REQUIRES: the tile lives as long as this is used.
  void reset(const HeightTile& tile);

  /// At node (i, j), each 0..N.
  double kappa(int i, int j) const;

 private:
  int clampRow(int j) const;
  double gradientEast(int i, int j) const;
  double gradientNorth(int i, int j) const;

  const HeightTile* tile_ = nullptr;
  /// By row from the first that exists: metres from the column to the west to that to the east, and
  /// from the row to the south to that to the north; 0 at a pole.
  std::vector<double> east_, north_;
};

/// Cumulated curvature: sums of kappa over rectangles of nodes.
class CumulatedCurvature {
 public:
  void reset(const HeightTile& tile, const Curvature& curvature);

  /// Sum over the nodes of columns i..i+cells and rows j..j+cells.
  double ofCell(int i, int j, int cells) const;

 private:
  double below(int i, int j) const { return sums_[std::size_t(j * stride_ + i)]; }

  int stride_ = 0;
  std::vector<double> sums_; ///< over the nodes west and south of a corner
};

} // namespace qmesh
