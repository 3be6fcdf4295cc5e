// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/tile_frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesh/lanes.h"

namespace qmesh {

namespace {

/// n is capped so that an interior step is never finer than this, metres.
constexpr double kFinestInteriorStep = 1.0 / 4096;
/// Relative distance of two float32 numbers at worst.
constexpr double kFloatEpsilon = 1.0 / (1 << 23);

struct HeightRange {
  float min;
  float max;
};

QMESH_VECTOR_CLONES HeightRange nodeRange(const HeightTile& tile) {
  using Floats = Lanes<float>::Reals;
  constexpr int lanes = Lanes<float>::kCount;
  const int cells = tile.cells(); // a multiple of the lanes
  Floats low = Floats{} + tile.at(0, 0), high = low;
  for (int j = 0; j <= cells; ++j) {
    const float* row = tile.row(j);
    for (int i = 1; i <= cells; i += lanes) {
      Floats heights;
      std::memcpy(&heights, row + i, sizeof heights);
      low = heights < low ? heights : low;
      high = heights > high ? heights : high;
    }
  }
  HeightRange range{low[0], high[0]};
  for (int k = 0; k < lanes; ++k)
    range = {std::min(range.min, low[k]), std::max(range.max, high[k])};
  for (int j = 0; j <= cells; ++j)
    range = {std::min(range.min, tile.at(0, j)), std::max(range.max, tile.at(0, j))};
  return range;
}

float highestBorderNode(const HeightTile& tile) {
  const int n = tile.cells();
  float highest = tile.at(0, 0);
  for (int k = 0; k <= n; ++k)
    highest = std::max({highest, tile.at(k, 0), tile.at(k, n), tile.at(0, k), tile.at(n, k)});
  return highest;
}

/// The largest multiple of the step, not above the height, that float32 holds exactly.
double lowestMultiple(double height, double step) {
  double multiple = std::floor(height / step);
  for (double grain = 2; double(float(multiple * step)) != multiple * step; grain *= 2)
    multiple = std::floor(multiple / grain) * grain;
  return multiple;
}

} // namespace

double roundToLattice(double height, double step) {
  return std::floor(height / step + 0.5) * step;
}

void TileFrame::reset(const HeightTile& tile, const LevelParams& level) {
  setPositions(tile);

  const HeightRange range = nodeRange(tile);
  const double highestBorder = highestBorderNode(tile);
  latticeStep_ = level.latticeStep;
  double top = 0;
  while (true) {
    minMultiple_ = lowestMultiple(range.min, latticeStep_);
    top = std::max(double(range.max), roundToLattice(highestBorder, latticeStep_));
    const double reach = minMultiple_ * latticeStep_ + kQuantizedMax * latticeStep_;
    if (reach >= top && float(reach) > float(minMultiple_ * latticeStep_))
      break;
    latticeStep_ *= 2;
  }
  coarseStep_ = latticeStep_ > level.latticeStep ? latticeStep_ : 0;

  const double bottom = minMultiple_ * latticeStep_;
  const double finest = std::max(kFinestInteriorStep, std::abs(bottom) * kFloatEpsilon);
  const double cap = std::max(1.0, latticeStep_ / finest);
  divisions_ = int(std::min(cap, std::floor(kQuantizedMax * latticeStep_ / (top - bottom))));
  min_ = float(bottom);
  max_ = float(bottom + kQuantizedMax * latticeStep_ / divisions_);
  step_ = (double(max_) - double(min_)) / kQuantizedMax;
}

void TileFrame::setPositions(const HeightTile& tile) {
  const NodeLattice& lattice = tile.lattice();
  cells_ = tile.cells();
  const auto count = std::size_t(cells_) + 1;
  nodeU_.resize(count);
  nodeV_.resize(count);
  u_.resize(count);
  v_.resize(count);
  const double south = lattice.latitude(tile.row0());
  const double north = lattice.latitude(tile.row0() + cells_);
  const bool uniform = lattice.scheme().profile() == Profile::geodetic;
  for (int k = 0; k <= cells_; ++k) {
    const double even = double(kQuantizedMax) * k / cells_;
    nodeU_[std::size_t(k)] = even;
    nodeV_[std::size_t(k)] =
        uniform ? even
                : kQuantizedMax * ((lattice.latitude(tile.row0() + k) - south) / (north - south));
    u_[std::size_t(k)] = std::uint16_t(even + 0.5);
    v_[std::size_t(k)] = std::uint16_t(nodeV_[std::size_t(k)] + 0.5);
  }
}

int TileFrame::nearestColumn(std::uint16_t u) const {
  return (int(u) * cells_ + kQuantizedMax / 2) / kQuantizedMax;
}

int TileFrame::nearestRow(std::uint16_t v) const {
  int row = (int(v) * cells_ + kQuantizedMax / 2) / kQuantizedMax; // right where rows are even
  while (row > 0 && v - nodeV(row - 1) < nodeV(row) - v)
    --row;
  while (row < cells_ && nodeV(row + 1) - v <= v - nodeV(row))
    ++row;
  return row;
}

std::uint16_t TileFrame::quantize(float height) const {
  const double q = std::floor((double(height) - min_) / step_ + 0.5);
  return std::uint16_t(std::clamp(q, 0.0, double(kQuantizedMax)));
}

std::uint16_t TileFrame::quantizeBorder(float height) const {
  const double multiple = std::floor(height / latticeStep_ + 0.5);
  return std::uint16_t((multiple - minMultiple_) * divisions_);
}

} // namespace qmesh
