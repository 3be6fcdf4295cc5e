// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/node_heights.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace qmesh {

namespace {

using Floats = Lanes<float>::Reals;
using Ints = Lanes<float>::Ints;
constexpr int kLanes = Lanes<float>::kCount;
constexpr std::int32_t kNoBlock = std::numeric_limits<std::int32_t>::max();

/// What the scan of a triangle reads.
struct ScanInput {
  const SpanCorner* a;
  const SpanCorner* b;
  const SpanCorner* c;
  const float* nodeV;
  const float* heights;
  std::int32_t stride;
  double columnUnits;
  float tolerance;
};

/// A lane of a numbered block of eight nodes, and the error there.
struct BlockError {
  std::int32_t block;
  std::int32_t lane;
  float error;
};

QMESH_INLINE float largestLane(const Floats& values) {
  Lanes<float>::HalfReals low, high;
  std::memcpy(&low, &values, sizeof low);
  std::memcpy(&high, reinterpret_cast<const char*>(&values) + sizeof low, sizeof high);
  const Lanes<float>::HalfReals pairs = low > high ? low : high;
  const auto larger = [](float a, float b) { return a > b ? a : b; };
  return larger(larger(pairs[0], pairs[1]), larger(pairs[2], pairs[3]));
}

/// The lane with a given error; of several that of the first block, then the first lane.
QMESH_INLINE BlockError laneOf(float error, const Floats& errors, const Ints& blocks) {
  BlockError best{kNoBlock, 0, error};
  for (int lane = 0; lane < kLanes; ++lane) {
    if (errors[lane] == error && blocks[lane] < best.block) {
      best.block = blocks[lane];
      best.lane = lane;
    }
  }
  return best;
}

/// The node of a lane: rows take one block at least, and one for every eight nodes.
NodeError findNode(const SpanList<float>& list, std::int32_t stride, const BlockError& best) {
  std::int32_t block = best.block;
  int r = 0;
  const auto blocksOf = [&](int row) {
    return std::max(1, (list.count[row] + kLanes - 1) / kLanes);
  };
  for (; block >= blocksOf(r); ++r)
    block -= blocksOf(r);
  const int column = list.begin[r] + block * kLanes + best.lane;
  return {(list.firstRow + r) * stride + column, best.error};
}

/// By lanes: the largest error above a tolerance, and where.
struct LargestErrors {
  Floats worst;
  Ints blocks = Ints{} + kNoBlock;
  Ints block = {}; ///< number of the next one

  QMESH_INLINE explicit LargestErrors(float tolerance) : worst(Floats{} + tolerance) {}
  QMESH_INLINE void add(const Floats& error, const Ints& inside) {
    const Ints worse = (error > worst) & inside;
    worst = worse ? error : worst;
    blocks = worse ? block : blocks;
    block += 1;
  }
};

/// By lanes: whether an error is above a tolerance.
struct AnyError {
  Floats tolerance;
  Ints found = {};

  QMESH_INLINE explicit AnyError(float above) : tolerance(Floats{} + above) {}
  QMESH_INLINE void add(const Floats& error, const Ints& inside) {
    found |= (error > tolerance) & inside;
  }
};

/// Adds the errors of all nodes of a triangle. A masked node is NaN and compares false.
template <class Errors>
QMESH_INLINE void scanTriangle(const ScanInput& in, SpanList<float>& list, Errors& errors) {
  const auto slope = float(heightPerColumn(*in.a, *in.b, *in.c, in.columnUnits));
  listSpans(*in.a, *in.b, *in.c, in.nodeV, slope, list);
  const Ints lanes = {0, 1, 2, 3, 4, 5, 6, 7};
  const Floats rise = __builtin_convertvector(lanes, Floats) * slope;
  Errors sum = errors;
  const float* row = in.heights + std::ptrdiff_t(list.firstRow) * in.stride;
  for (int r = 0; r < list.rows; ++r, row += in.stride) {
    const float* from = row + list.begin[r];
    const float* end = from + list.count[r];
    Floats plane = list.height[r] + rise;
    Ints left = Ints{} + list.count[r];
    do { // also for a row without nodes: cheaper than to foresee which one it is
      Floats error;
      std::memcpy(&error, from, sizeof error);
      sum.add(Floats(Ints(plane - error) & 0x7fffffff), lanes < left);
      plane += kLanes * slope;
      left -= kLanes;
      from += kLanes;
    } while (from < end);
  }
  errors = sum;
}

QMESH_VECTOR_CLONES NodeError findWorst(const ScanInput& in) {
  SpanList<float> list;
  LargestErrors errors(in.tolerance);
  scanTriangle(in, list, errors);
  const float largest = largestLane(errors.worst);
  if (largest == in.tolerance)
    return {};
  return findNode(list, in.stride, laneOf(largest, errors.worst, errors.blocks));
}

QMESH_VECTOR_CLONES bool findAny(const ScanInput& in) {
  SpanList<float> list;
  AnyError errors(in.tolerance);
  scanTriangle(in, list, errors);
  std::uint64_t found[sizeof errors.found / sizeof(std::uint64_t)];
  std::memcpy(found, &errors.found, sizeof found);
  return (found[0] | found[1] | found[2] | found[3]) != 0;
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

void NodeHeights::mask(int i, int j) {
  heights_[std::size_t(index(i, j))] = std::numeric_limits<float>::quiet_NaN();
}

void NodeHeights::unmask(int i, int j) {
  heights_[std::size_t(index(i, j))] = tile_->at(i, j) - minimum_;
}

bool NodeHeights::isMasked(std::int32_t node) const {
  return std::isnan(heights_[std::size_t(node)]);
}

NodeError NodeHeights::worst(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                             float tolerance) const {
  return findWorst(
      {&a, &b, &c, nodeV_.data(), heights_.data(), stride_, unitsPerColumn(cells_), tolerance});
}

bool NodeHeights::areWithin(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                            float tolerance) const {
  return !findAny(
      {&a, &b, &c, nodeV_.data(), heights_.data(), stride_, unitsPerColumn(cells_), tolerance});
}

} // namespace qmesh
