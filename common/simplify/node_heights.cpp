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

/// The largest of the lanes; of equal ones the smallest node.
NodeError best(const float* errors, const std::int32_t* nodes) {
  NodeError found;
  for (int lane = 0; lane < kLanes; ++lane) {
    if (nodes[lane] < 0)
      continue;
    if (found.node < 0 || errors[lane] > found.error ||
        (errors[lane] == found.error && nodes[lane] < found.node))
      found = {nodes[lane], errors[lane]};
  }
  return found;
}

QMESH_VECTOR_CLONES NodeError scanTriangle(const ScanInput& in) {
  SpanList<float> list;
  const auto slope = float(heightPerColumn(*in.a, *in.b, *in.c, in.cells));
  listSpans(*in.a, *in.b, *in.c, in.nodeV, slope, list);

  const Ints lanes = {0, 1, 2, 3, 4, 5, 6, 7};
  const Floats rise = __builtin_convertvector(lanes, Floats) * slope;
  Floats worst = Floats{} + in.tolerance;
  Ints nodes = Ints{} - 1;
  for (int r = 0; r < list.rows; ++r) {
    const std::int32_t row = (list.firstRow + r) * in.stride;
    for (int i = list.begin[r]; i < list.end[r]; i += kLanes) {
      Floats heights;
      std::memcpy(&heights, in.heights + row + i, sizeof heights);
      const float height = list.height[r] + float(i - list.begin[r]) * slope;
      Floats error = (height + rise) - heights;
      error = Floats(Ints(error) & 0x7fffffff);
      // A masked node is NaN and compares false.
      const Ints worse = (error > worst) & (lanes < (list.end[r] - i));
      worst = worse ? error : worst;
      nodes = worse ? lanes + (row + i) : nodes;
    }
  }
  float errors[kLanes];
  std::int32_t found[kLanes];
  std::memcpy(errors, &worst, sizeof errors);
  std::memcpy(found, &nodes, sizeof found);
  return best(errors, found);
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
