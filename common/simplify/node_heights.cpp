// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/node_heights.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace qmesh {

namespace {

using Floats = Lanes<float>::Reals;
using Ints = Lanes<float>::Ints;
constexpr int kLanes = Lanes<float>::kCount;
constexpr std::int32_t kNoNode = std::numeric_limits<std::int32_t>::max();

/// What the scan of a triangle reads.
struct ScanInput {
  const SpanCorner* a;
  const SpanCorner* b;
  const SpanCorner* c;
  const float* nodeV;
  const float* heights;
  std::int32_t stride;
  int cells;
  float tolerance;
};

/// The largest of the lanes' errors; of equal ones the smallest node. Without branches: which lane
/// wins cannot be foreseen.
QMESH_INLINE NodeError bestLane(const Floats& errors, const Ints& nodes) {
  NodeError found;
  found.error = errors[0];
  for (int lane = 1; lane < kLanes; ++lane)
    found.error = errors[lane] > found.error ? errors[lane] : found.error;
  const Ints winners = errors == (Floats{} + found.error) ? nodes : Ints{} + kNoNode;
  found.node = winners[0];
  for (int lane = 1; lane < kLanes; ++lane)
    found.node = winners[lane] < found.node ? winners[lane] : found.node;
  return found;
}

QMESH_VECTOR_CLONES NodeError scanTriangle(const ScanInput& in) {
  SpanList<float> list;
  const auto slope = float(heightPerColumn(*in.a, *in.b, *in.c, in.cells));
  listSpans(*in.a, *in.b, *in.c, in.nodeV, slope, list);

  const Ints lanes = {0, 1, 2, 3, 4, 5, 6, 7};
  const Floats rise = __builtin_convertvector(lanes, Floats) * slope;
  const float laneRise = kLanes * slope;
  Floats worst = Floats{} + in.tolerance;
  Ints nodes = Ints{} + kNoNode;
  const float* row = in.heights + std::ptrdiff_t(list.firstRow) * in.stride;
  std::int32_t rowIndex = list.firstRow * in.stride;
  for (int r = 0; r < list.rows; ++r, row += in.stride, rowIndex += in.stride) {
    int i = list.begin[r];
    const int end = list.end[r];
    float height = list.height[r];
    do { // also for a row without nodes: cheaper than to foresee which one it is
      Floats heights;
      std::memcpy(&heights, row + i, sizeof heights);
      Floats error = (height + rise) - heights;
      error = Floats(Ints(error) & 0x7fffffff);
      // A masked node is NaN and compares false.
      const Ints worse = (error > worst) & (lanes < (end - i));
      worst = worse ? error : worst;
      nodes = worse ? lanes + (rowIndex + i) : nodes;
      height += laneRise;
      i += kLanes;
    } while (i < end);
  }
  NodeError found = bestLane(worst, nodes);
  if (found.node == kNoNode)
    found = {};
  return found;
}

} // namespace

void NodeHeights::reset(const HeightTile& tile, const TileFrame& frame) {
  tile_ = &tile;
  minimum_ = frame.minHeight();
  cells_ = tile.cells();
  stride_ = cells_ + 1;
  range_ = frame.maxHeight() - frame.minHeight();
  heights_.resize(std::size_t(stride_) * std::size_t(stride_) + kLanes);
  float* to = heights_.data();
  nodeV_.clear();
  for (int j = 0; j <= cells_; ++j) {
    nodeV_.push_back(float(frame.nodeV(j)));
    const float* from = tile.row(j);
    for (int i = 0; i <= cells_; ++i)
      *to++ = from[i] - minimum_;
  }
  nodeV_.resize(nodeV_.size() + kLanePadding, float(kQuantizedMax));
}

void NodeHeights::mask(std::int32_t node) {
  heights_[std::size_t(node)] = std::numeric_limits<float>::quiet_NaN();
}

void NodeHeights::unmask(std::int32_t node) {
  heights_[std::size_t(node)] = tile_->at(column(node), row(node)) - minimum_;
}

bool NodeHeights::isMasked(std::int32_t node) const {
  return std::isnan(heights_[std::size_t(node)]);
}

NodeError NodeHeights::worst(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                             float tolerance) const {
  return scanTriangle({&a, &b, &c, nodeV_.data(), heights_.data(), stride_, cells_, tolerance});
}

} // namespace qmesh
