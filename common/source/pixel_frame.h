// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>

namespace qmesh {

/// Where a raster's pixels lie in its coordinate system. Pixel space is continuous: pixel (c, r)
/// is the square c..c+1, r..r+1 and its centre is at +0.5.
struct PixelFrame {
  std::array<double, 6> toWorld{0, 1, 0, 0, 0, 1};   ///< GDAL's geotransform
  std::array<double, 6> fromWorld{0, 1, 0, 0, 0, 1}; ///< its inverse
  double width = 0;                                  ///< pixels; whole but in a reduced frame
  double height = 0;
  double turn = 0;    ///< a full turn of x, see fullTurn(); 0 where x does not go round
  double centreX = 0; ///< x of the middle of the raster
  int period = 0;     ///< columns of a full turn where the raster covers one, else 0

  /// False where the geotransform cannot be turned round. Sets all but the arguments' fields.
  bool set(const std::array<double, 6>& geoTransform, int columns, int rows, double fullTurn);

  bool rotated() const { return toWorld[2] != 0 || toWorld[4] != 0; }

  /// x brought by whole turns to within half a turn of the raster's middle.
  double unwrapped(double x) const;

  /// Pixel position of a place; x is unwrapped first.
  void toPixel(double x, double y, double& column, double& row) const;
  void toPlace(double column, double row, double& x, double& y) const;

  /// The frame of the same raster with pixels `factorX` x `factorY` times as large (both >= 1);
  /// the number of columns in a turn must stay whole.
  PixelFrame reduced(double factorX, double factorY) const;
};

} // namespace qmesh
