// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>

#include "border/border.h"

namespace qmesh {

/// A stretch of an edge between two nodes, from < to, a power of two apart.
struct EdgeStretch {
  Edge edge;
  int from;
  int to;
  double error; ///< the largest of its nodes from the straight line between its ends, metres
};

/// Whether a stretch is cut in two. A stretch of two neighbouring nodes that is cut gets the other
/// places of its ends, as in makeBorder(). For promise P1 the answer must follow from the nodes of
/// the edge, those to both sides of it and the level.
using StretchRule = std::function<bool(const EdgeStretch&)>;

/// Edges by repeated halving of the base grid's stretches; a pole's edge is not halved.
void makeDyadicBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                      const StretchRule& cuts, Border& border);

} // namespace qmesh
