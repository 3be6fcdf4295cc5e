// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/height_tile.h"
#include "mesh/tile_frame.h"
#include "mesh/triangle_spans.h"

namespace qmesh {

/// A node of the tile and how far a triangle's plane is from it.
struct NodeError {
  std::int32_t node = -1; ///< NodeHeights::index, -1: none
  float error = 0;        ///< metres
};

/// The node heights of one tile for the fast scan: float32 metres above the frame's minimum. A node
/// that needs no more attention (a vertex, a node of the border) is masked and never found.
class NodeHeights {
 public:
  /// REQUIRES: the tile lives as long as the heights are used.
  void reset(const HeightTile& tile, const TileFrame& frame);

  std::int32_t index(int i, int j) const { return j * stride_ + i; }
  int column(std::int32_t node) const { return node % stride_; }
  int row(std::int32_t node) const { return node / stride_; }

  void mask(int i, int j);
  void unmask(int i, int j);
  bool isMasked(std::int32_t node) const;

  /// The unmasked node of a counter-clockwise triangle whose error is largest and above the
  /// tolerance; of equal ones the smallest index. Corner heights are above the frame's minimum.
  NodeError worst(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                  float tolerance) const;
  /// True where worst() would find none; faster.
  bool areWithin(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                 float tolerance) const;

  /// The max error less what the float32 arithmetic of the scan may get wrong, metres.
  float scanTolerance(double maxError) const {
    const double margin = double(range_) / (1 << 21);
    return float(maxError - std::min(margin, maxError / 16));
  }

 private:
  const HeightTile* tile_ = nullptr;
  float minimum_ = 0;
  std::vector<float> heights_; ///< (N+1) rows of stride_ floats and one vector's worth behind
  std::vector<float> nodeV_;
  std::int32_t stride_ = 0;
  int cells_ = 0;
  float range_ = 0; ///< of the heights: the scan errs by a few float32 digits of it
};

} // namespace qmesh
