// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "grid/node_window.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace qmesh {

void NodeWindow::reset(const NodeLattice& lattice, const TileRange& tiles, int halo) {
  lattice_ = lattice;
  tiles_ = tiles;
  halo_ = halo;
  const std::int64_t n = lattice.cells();
  column0_ = std::int64_t(tiles.x0) * n - halo;
  row0_ = std::int64_t(tiles.y0) * n - halo;
  width_ = int((std::int64_t(tiles.x1) - tiles.x0 + 1) * n + 1 + 2 * halo);
  height_ = int((std::int64_t(tiles.y1) - tiles.y0 + 1) * n + 1 + 2 * halo);
  nodes_.assign(std::size_t(width_) * std::size_t(height_),
                std::numeric_limits<float>::quiet_NaN());
  filled_.clear();
}

void NodeWindow::fill(int a, int b, float height) {
  filled_.resize(nodes_.size());
  const std::size_t node = std::size_t(b) * std::size_t(width_) + std::size_t(a);
  nodes_[node] = height;
  filled_[node] = 1;
}

int NodeWindow::firstExistingRow() const {
  return int(std::max<std::int64_t>(0, -row0_));
}

int NodeWindow::endExistingRow() const {
  return int(std::min<std::int64_t>(height_, lattice_.lastRow() + 1 - row0_));
}

void NodeWindow::setPoles(double southHeight, double northHeight) {
  if (lattice_.scheme().profile() != Profile::geodetic)
    return;
  const auto set = [&](std::int64_t j, double value) {
    const std::int64_t b = j - row0_;
    if (b < 0 || b >= height_ || std::isnan(value))
      return;
    std::fill_n(row(int(b)), width_, float(value));
  };
  set(0, southHeight);
  set(lattice_.lastRow(), northHeight);
}

HeightTile NodeWindow::tile(TileId id) const {
  assert(halo_ >= kTileHalo && tiles_.contains(id.x, id.y) && id.z == lattice_.zoom());
  const int n = lattice_.cells();
  const int a = int(id.x - tiles_.x0) * n + halo_;
  const int b = int(id.y - tiles_.y0) * n + halo_;
  const std::uint8_t* filled =
      filled_.empty() ? nullptr : filled_.data() + std::ptrdiff_t(b) * stride() + a;
  return {id, lattice_, row(b) + a, stride(), filled};
}

bool NodeWindow::isVoid(TileId id) const {
  const HeightTile view = tile(id);
  const int n = lattice_.cells();
  for (int j = 0; j <= n; ++j) {
    const float* nodes = view.row(j);
    if (!std::all_of(nodes, nodes + n + 1, [](float h) { return std::isnan(h); }))
      return false;
  }
  return true;
}

bool NodeWindow::anyHeight() const {
  return std::any_of(nodes_.begin(), nodes_.end(), [](float h) { return !std::isnan(h); });
}

std::size_t NodeWindow::bytes(int tilesX, int tilesY, int cells, int halo) {
  const std::size_t border = std::size_t(1 + 2 * halo);
  return (std::size_t(tilesX) * std::size_t(cells) + border) *
         (std::size_t(tilesY) * std::size_t(cells) + border) *
         (sizeof(float) + sizeof(std::uint8_t));
}

} // namespace qmesh
