// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/pixel_frame.h"

#include <cmath>

#include <gdal.h>

namespace qmesh {
namespace {

/// A global raster may miss the full turn by this much of a pixel (a rounded cell size in its
/// header) and still goes round.
constexpr double kTurnTolerance = 0.25;

} // namespace

bool PixelFrame::set(const std::array<double, 6>& geoTransform, int columns, int rows,
                     double fullTurn) {
  toWorld = geoTransform;
  for (double value : toWorld)
    if (!std::isfinite(value))
      return false;
  if (!GDALInvGeoTransform(toWorld.data(), fromWorld.data()))
    return false;
  width = columns;
  height = rows;
  turn = fullTurn;
  double y = 0;
  toPlace(width / 2, height / 2, centreX, y);
  period = 0;
  if (turn > 0 && !rotated()) {
    const double columnsPerTurn = turn / std::abs(toWorld[1]);
    const double whole = std::round(columnsPerTurn);
    if (whole <= width && std::abs(columnsPerTurn - whole) <= kTurnTolerance)
      period = int(whole);
  }
  return true;
}

double PixelFrame::unwrapped(double x) const {
  return turn > 0 ? x - turn * std::floor((x - centreX) / turn + 0.5) : x;
}

void PixelFrame::toPixel(double x, double y, double& column, double& row) const {
  const double ux = unwrapped(x);
  if (rotated()) {
    column = fromWorld[0] + ux * fromWorld[1] + y * fromWorld[2];
    row = fromWorld[3] + ux * fromWorld[4] + y * fromWorld[5];
  } else { // a division rounds once, so whole pixels stay whole
    column = (ux - toWorld[0]) / toWorld[1];
    row = (y - toWorld[3]) / toWorld[5];
  }
}

void PixelFrame::toPlace(double column, double row, double& x, double& y) const {
  x = toWorld[0] + column * toWorld[1] + row * toWorld[2];
  y = toWorld[3] + column * toWorld[4] + row * toWorld[5];
}

PixelFrame PixelFrame::reduced(double factorX, double factorY) const {
  PixelFrame out = *this;
  for (int k : {1, 4}) {
    out.toWorld[k] *= factorX;
    out.toWorld[k + 1] *= factorY;
  }
  for (int k : {0, 1, 2}) {
    out.fromWorld[k] /= factorX;
    out.fromWorld[k + 3] /= factorY;
  }
  out.width /= factorX;
  out.height /= factorY;
  out.period = int(std::round(period / factorX));
  return out;
}

} // namespace qmesh
