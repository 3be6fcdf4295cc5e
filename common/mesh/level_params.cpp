// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/level_params.h"

#include <algorithm>
#include <cmath>

#include "geo/ellipsoid.h"
#include "mesh/tile_frame.h"

namespace qmesh {

namespace {

constexpr double kFinestStep = 1.0 / 1024;
/// No terrain on Earth or its sea floor differs by more within a tile, metres.
constexpr double kLargestRelief = 16000;

/// The smallest power of two, from kFinestStep on, whose 32767 steps span a range of heights.
double stepFor(double rangeMetres) {
  double step = kFinestStep;
  while (kQuantizedMax * step < rangeMetres)
    step *= 2;
  return step;
}

} // namespace

double latticeStep(const Scheme& scheme, int zoom, double maxErrorMetres) {
  const double size = scheme.tileMetres(zoom);
  const double least = stepFor(std::min(kLargestRelief, size));
  double step = stepFor(std::min(double(kQuantizedMax), 4 * size));
  while (step > least && step > maxErrorMetres / 2)
    step /= 2;
  return step;
}

int baseGridOf(const Scheme& scheme, int zoom, double maxErrorMetres, int cellsPerTile) {
  const double tileRadians = 2 * wgs84::kPi / scheme.tilesX(zoom);
  const double cellRadians = std::sqrt(4 * maxErrorMetres / wgs84::kSemiMajor);
  int cells = 1;
  while (cells < cellsPerTile && cells * cellRadians < tileRadians)
    cells *= 2;
  return cells;
}

LevelParams levelParams(const Scheme& scheme, int zoom, double maxErrorMetres, int cellsPerTile) {
  LevelParams level;
  level.zoom = zoom;
  level.maxError = maxErrorMetres;
  level.latticeStep = latticeStep(scheme, zoom, maxErrorMetres);
  level.baseGrid = baseGridOf(scheme, zoom, maxErrorMetres, cellsPerTile);
  return level;
}

} // namespace qmesh
