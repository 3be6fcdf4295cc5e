// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/node_heights.h"

#include <cmath>
#include <cstring>
#include <limits>

// The scan twice, for processors with and without 8 floats in a register; both give the same bits.
// Sanitizers do not run before the resolver of such functions does, so they get the plain one.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define QMESH_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define QMESH_VECTOR_CLONES
#endif

namespace qmesh {

namespace {

constexpr int kLanes = 8;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = std::int32_t __attribute__((vector_size(4 * kLanes)));

/// What the scan of a triangle reads.
struct ScanInput {
  const SpanCorner* a;
  const SpanCorner* b;
  const SpanCorner* c;
  const double* nodeV;
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
  const double slope = heightPerColumn(*in.a, *in.b, *in.c, in.cells);
  const Ints lanes = {0, 1, 2, 3, 4, 5, 6, 7};
  const Floats steps = {0, 1, 2, 3, 4, 5, 6, 7};
  const Floats rise = steps * float(slope);
  Floats worst = Floats{} + in.tolerance;
  Ints nodes = Ints{} - 1;
  const auto visit = [&](int j, int i0, int i1, double height) {
    const std::int32_t first = j * in.stride + i0;
    const int count = i1 - i0;
    for (int k = 0; k < count; k += kLanes) {
      Floats node;
      std::memcpy(&node, in.heights + first + k, sizeof node);
      Floats error = node - (float(height + k * slope) + rise);
      error = Floats(Ints(error) & 0x7fffffff);
      // A masked node is NaN and compares false.
      const Ints worse = (error > worst) & (lanes < count - k);
      worst = worse ? error : worst;
      nodes = worse ? lanes + (first + k) : nodes;
    }
  };
  forEachSpan(*in.a, *in.b, *in.c, in.nodeV, in.cells, slope, visit);
  float errors[kLanes];
  std::int32_t found[kLanes];
  std::memcpy(errors, &worst, sizeof errors);
  std::memcpy(found, &nodes, sizeof found);
  return best(errors, found);
}

} // namespace

void NodeHeights::reset(const HeightTile& tile, const TileFrame& frame) {
  cells_ = tile.cells();
  stride_ = cells_ + 1;
  range_ = frame.maxHeight() - frame.minHeight();
  heights_.resize(std::size_t(stride_) * std::size_t(stride_) + kLanes);
  float* to = heights_.data();
  nodeV_.clear();
  for (int j = 0; j <= cells_; ++j) {
    nodeV_.push_back(frame.nodeV(j));
    const float* from = tile.row(j);
    for (int i = 0; i <= cells_; ++i)
      *to++ = from[i] - frame.minHeight();
  }
}

void NodeHeights::mask(std::int32_t node) {
  heights_[std::size_t(node)] = std::numeric_limits<float>::quiet_NaN();
}

void NodeHeights::unmask(std::int32_t node, float heightAboveMinimum) {
  heights_[std::size_t(node)] = heightAboveMinimum;
}

bool NodeHeights::isMasked(std::int32_t node) const {
  return std::isnan(heights_[std::size_t(node)]);
}

NodeError NodeHeights::worst(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                             float tolerance) const {
  return scanTriangle({&a, &b, &c, nodeV_.data(), heights_.data(), stride_, cells_, tolerance});
}

} // namespace qmesh
