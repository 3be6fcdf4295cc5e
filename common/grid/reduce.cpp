// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "grid/reduce.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace qmesh {

namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

/// The fine window by node offset from one of its rows, void outside.
float fineNode(const NodeWindow& fine, std::int64_t a, std::int64_t b) {
  if (a < 0 || b < 0 || a >= fine.width() || b >= fine.height())
    return kVoid;
  return fine.row(int(b))[a];
}

/// [1 2 1] x [1 2 1] over the valid nodes around (a, b); the general, slow form.
float averageWithVoids(const NodeWindow& fine, std::int64_t a, std::int64_t b) {
  float sum = 0;
  float weight = 0;
  for (int db = -1; db <= 1; ++db) {
    for (int da = -1; da <= 1; ++da) {
      const float h = fineNode(fine, a + da, b + db);
      if (std::isnan(h))
        continue;
      const float w = float((2 - std::abs(da)) * (2 - std::abs(db)));
      sum += w * h;
      weight += w;
    }
  }
  return weight >= 8 ? sum / weight : kVoid;
}

/// [1 2 1] x [1 2 1] / 16 of three whole rows at column a: NaN when a node is void.
float averageOfRows(const float* south, const float* middle, const float* north, std::int64_t a) {
  const float s = south[a - 1] + 2 * south[a] + south[a + 1];
  const float m = middle[a - 1] + 2 * middle[a] + middle[a + 1];
  const float n = north[a - 1] + 2 * north[a] + north[a + 1];
  return (s + 2 * m + n) * (1.0f / 16);
}

void averageRow(const NodeWindow& fine, std::int64_t a0, std::int64_t b, float* out, int width) {
  const bool inside = b >= 1 && b + 1 < fine.height();
  for (int k = 0; k < width; ++k) {
    const std::int64_t a = a0 + 2 * k;
    float h = kVoid;
    if (inside && a >= 1 && a + 1 < fine.width()) {
      const int row = int(b);
      h = averageOfRows(fine.row(row - 1), fine.row(row), fine.row(row + 1), a);
    }
    out[k] = std::isnan(h) ? averageWithVoids(fine, a, b) : h;
  }
}

float cubicNode(const NodeWindow& fine, std::int64_t a, std::int64_t b) {
  constexpr float kWeights[4] = {16, 9, 0, -1};
  if (a < 3 || b < 3 || a + 3 >= fine.width() || b + 3 >= fine.height())
    return kVoid;
  float sum = 0;
  for (int db = -3; db <= 3; ++db) {
    const float* row = fine.row(int(b + db)) + a;
    float line = 0;
    for (int da = -3; da <= 3; ++da)
      line += kWeights[std::abs(da)] * row[da];
    sum += kWeights[std::abs(db)] * line;
  }
  return sum * (1.0f / 1024);
}

void cubicRow(const NodeWindow& fine, std::int64_t a0, std::int64_t b, float* out, int width) {
  for (int k = 0; k < width; ++k) {
    const std::int64_t a = a0 + 2 * k;
    const float h = cubicNode(fine, a, b);
    out[k] = std::isnan(h) ? averageWithVoids(fine, a, b) : h;
  }
}

} // namespace

int reductionRadius(OverviewResampling filter) {
  switch (filter) {
  case OverviewResampling::nearest:
    return 0;
  case OverviewResampling::average:
    return 1;
  case OverviewResampling::cubic:
    return 3;
  }
  return 1;
}

int haloForLevels(OverviewResampling filter, int levels) {
  const int radius = reductionRadius(filter);
  return (std::max(kTileHalo, radius) << levels) + radius * ((1 << levels) - 1);
}

void reduceWindow(const NodeWindow& fine, OverviewResampling filter, NodeWindow& coarse) {
  assert(fine.lattice().zoom() == coarse.lattice().zoom() + 1);
  const std::int64_t a0 = 2 * coarse.column0() - fine.column0();
  for (int row = coarse.firstExistingRow(); row < coarse.endExistingRow(); ++row) {
    const std::int64_t b = 2 * (coarse.row0() + row) - fine.row0();
    float* out = coarse.row(row);
    switch (filter) {
    case OverviewResampling::nearest:
      for (int k = 0; k < coarse.width(); ++k)
        out[k] = fineNode(fine, a0 + 2 * k, b);
      break;
    case OverviewResampling::average:
      averageRow(fine, a0, b, out, coarse.width());
      break;
    case OverviewResampling::cubic:
      cubicRow(fine, a0, b, out, coarse.width());
      break;
    }
  }
}

} // namespace qmesh
