// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/quadtree/curvature.h"

#include <algorithm>
#include <cmath>

#include "geo/ellipsoid.h"

namespace qmesh {

void Curvature::reset(const HeightTile& tile) {
  tile_ = &tile;
  const NodeLattice& lattice = tile.lattice();
  east_.clear();
  north_.clear();
  for (int j = tile.firstRow(); j <= tile.lastRow(); ++j) {
    const std::int64_t row = tile.row0() + j;
    const double latitude = lattice.latitude(row);
    const double south = lattice.latitude(std::max<std::int64_t>(row - 1, 0));
    const double north = lattice.latitude(std::min(row + 1, lattice.lastRow()));
    const double degreesEast = lattice.isPole(row) ? 0 : 2 * lattice.spacingDegrees();
    east_.push_back(degreesEast * wgs84::metresPerDegreeEast(latitude));
    north_.push_back((north - south) * wgs84::metresPerDegreeNorth(latitude));
  }
}

int Curvature::clampRow(int j) const {
  return std::clamp(j, tile_->firstRow(), tile_->lastRow());
}

double Curvature::gradientEast(int i, int j) const {
  const double metres = east_[std::size_t(j - tile_->firstRow())];
  return metres > 0 ? (double(tile_->at(i + 1, j)) - tile_->at(i - 1, j)) / metres : 0;
}

double Curvature::gradientNorth(int i, int j) const {
  const double metres = north_[std::size_t(j - tile_->firstRow())];
  return (double(tile_->at(i, clampRow(j + 1))) - tile_->at(i, clampRow(j - 1))) / metres;
}

double Curvature::kappa(int i, int j) const {
  const int north = clampRow(j + 1), south = clampRow(j - 1);
  const double xx = gradientEast(i + 1, j) - gradientEast(i - 1, j);
  const double yx = gradientNorth(i + 1, j) - gradientNorth(i - 1, j);
  const double xy = gradientEast(i, north) - gradientEast(i, south);
  const double yy = gradientNorth(i, north) - gradientNorth(i, south);
  return std::sqrt(xx * xx + yx * yx + xy * xy + yy * yy);
}

void CumulatedCurvature::reset(const HeightTile& tile, const Curvature& curvature) {
  const int n = tile.cells();
  stride_ = n + 2;
  sums_.assign(std::size_t(stride_) * std::size_t(stride_), 0);
  for (int j = 0; j <= n; ++j) {
    double row = 0;
    for (int i = 0; i <= n; ++i) {
      row += curvature.kappa(i, j);
      sums_[std::size_t((j + 1) * stride_ + i + 1)] = below(i + 1, j) + row;
    }
  }
}

double CumulatedCurvature::ofCell(int i, int j, int cells) const {
  const int east = i + cells + 1, north = j + cells + 1;
  return below(east, north) - below(i, north) - below(east, j) + below(i, j);
}

} // namespace qmesh
