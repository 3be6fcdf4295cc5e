// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/enum_table.h"
#include "grid/node_window.h"

namespace qmesh {

/// How a level gets its heights from the finer one; see reduceWindow().
enum class OverviewResampling { nearest, average, cubic };

template <> struct EnumTable<OverviewResampling> {
  static constexpr EnumRow<OverviewResampling> kRows[] = {
      {OverviewResampling::nearest, "nearest", "every second node"},
      {OverviewResampling::average, "average", "weights 1 2 1 over valid nodes"},
      {OverviewResampling::cubic, "cubic", "sharper than average"},
      {OverviewResampling::nearest, "near"},
  };
};

/// Nodes of the finer level that the 2:1 reduction reads to each side of a node.
int reductionRadius(OverviewResampling filter);

/// Halo a window needs so that the level `levels` zooms above it still has h = max(kTileHalo, r)
/// nodes, enough for tiles and for one more reduction: 2^levels * h + r * (2^levels - 1).
int haloForLevels(OverviewResampling filter, int levels);

/// Fills a window of the coarser level, node on node: coarse (I, J) lies on fine (2I, 2J).
///   nearest   the node itself
///   average   [1 2 1] x [1 2 1] / 16
///   cubic     [-1 0 9 16 9 0 -1] x the same / 1024 where all of its nodes are valid, else average
/// Void nodes carry no weight; a node whose valid weight is below one half is void. What the fine
/// window does not hold counts as void: the caller sees to it that nothing is missing where there
/// is data. REQUIRES: `coarse` is reset to the level above; its content is overwritten.
void reduceWindow(const NodeWindow& fine, OverviewResampling filter, NodeWindow& coarse);

} // namespace qmesh
