// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "grid/void_fill.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace qmesh {

namespace {

/// Mean of the coarser level's nodes around a node of the window: itself, two or four of them.
float interpolate(const NodeWindow& coarser, std::int64_t column, std::int64_t row) {
  const std::int64_t a0 = (column >> 1) - coarser.column0();
  const std::int64_t b0 = (row >> 1) - coarser.row0();
  const int a1 = int(a0 + (column & 1));
  const int b1 = int(b0 + (row & 1));
  assert(a0 >= 0 && b0 >= 0 && a1 < coarser.width() && b1 < coarser.height());
  const float* south = coarser.row(int(b0));
  const float* north = coarser.row(b1);
  return ((south[a0] + south[a1]) + (north[a0] + north[a1])) * 0.25f;
}

} // namespace

void fillVoids(NodeWindow& window, float height) {
  for (int b = window.firstExistingRow(); b < window.endExistingRow(); ++b) {
    const float* row = window.row(b);
    for (int a = 0; a < window.width(); ++a) {
      if (std::isnan(row[a]))
        window.fill(a, b, height);
    }
  }
}

void fillVoidsOutside(NodeWindow& window, const Availability& tiles, float height) {
  const std::int64_t n = window.lattice().cells();
  const std::int64_t columns = window.lattice().columns();
  std::vector<bool> inside(std::size_t(window.width()) * std::size_t(window.height()));
  const auto mark = [&](const TileRange& r, std::int64_t shift) {
    const std::int64_t a0 = std::max<std::int64_t>(0, r.x0 * n + shift - window.column0());
    const std::int64_t a1 =
        std::min<std::int64_t>(window.width() - 1, (r.x1 + 1) * n + shift - window.column0());
    const std::int64_t b0 = std::max<std::int64_t>(0, r.y0 * n - window.row0());
    const std::int64_t b1 =
        std::min<std::int64_t>(window.height() - 1, (r.y1 + 1) * n - window.row0());
    for (std::int64_t b = b0; b <= b1 && a0 <= a1; ++b) {
      const auto row = inside.begin() + b * window.width();
      std::fill(row + a0, row + a1 + 1, true);
    }
  };
  for (const TileRange& r : tiles.ranges(window.lattice().zoom())) {
    for (const std::int64_t shift : {-columns, std::int64_t(0), columns})
      mark(r, shift);
  }
  for (int b = window.firstExistingRow(); b < window.endExistingRow(); ++b) {
    const float* row = window.row(b);
    for (int a = 0; a < window.width(); ++a) {
      const std::size_t node = std::size_t(b) * std::size_t(window.width()) + std::size_t(a);
      if (std::isnan(row[a]) && !inside[node])
        window.fill(a, b, height);
    }
  }
}

void fillVoids(NodeWindow& window, const NodeWindow& coarser) {
  assert(window.halo() >= kTileHalo && coarser.lattice().zoom() + 1 == window.lattice().zoom());
  const int margin = window.halo() - kTileHalo;
  const int first = std::max(window.firstExistingRow(), margin);
  const int end = std::min(window.endExistingRow(), window.height() - margin);
  for (int b = first; b < end; ++b) {
    float* row = window.row(b);
    for (int a = margin; a < window.width() - margin; ++a) {
      if (std::isnan(row[a])) {
        row[a] = interpolate(coarser, window.column0() + a, window.row0() + b);
      }
    }
  }
}

} // namespace qmesh
