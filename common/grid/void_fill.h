// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/enum_table.h"
#include "grid/node_window.h"

namespace qmesh {

/// Where the heights of void nodes come from.
enum class VoidFill { value, interpolate };

template <> struct EnumTable<VoidFill> {
  static constexpr EnumRow<VoidFill> kRows[] = {
      {VoidFill::value, "value", "one height"},
      {VoidFill::interpolate, "interpolate", "from the valid heights around"},
  };
};

/// Gives every void node of the window that exists on the lattice one height, metres.
void fillVoids(NodeWindow& window, float height);

/// The same for the void nodes that lie in no closed square of the level's `tiles`.
void fillVoidsOutside(NodeWindow& window, const Availability& tiles, float height);

/// Gives every void node the bilinear interpolation of the filled coarser level around it (the
/// "push" of pull-push interpolation: Gortler et al. 1996), so that a hole is bridged smoothly
/// whatever its size and each node is a function of its global position. Only nodes within
/// kTileHalo of the window's tiles are filled: what tiles need.
/// REQUIRES: `coarser` is filled and covers those nodes.
void fillVoids(NodeWindow& window, const NodeWindow& coarser);

} // namespace qmesh
