// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/base_grid.h"

#include <algorithm>

namespace qmesh {

BaseGrid::BaseGrid(const TileFrame& frame, const LevelParams& level)
    : cells_(frame.cells()), step_(cells_ / level.baseGrid) {
  if (level.baseGrid == 1)
    return;
  // Rounded places; in mercator tiles the rows are not evenly spaced either.
  std::int64_t widest = 0, highest = 0;
  for (int k = step_; k <= cells_; k += step_) {
    widest = std::max<std::int64_t>(widest, frame.u(k) - frame.u(k - step_));
    highest = std::max<std::int64_t>(highest, frame.v(k) - frame.v(k - step_));
  }
  longest_ = widest * widest + highest * highest;
}

void BaseGrid::addNodes(int cellsPerEdge) {
  step_ = std::min(step_, cells_ / cellsPerEdge);
}

} // namespace qmesh
