// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <limits>
#include <vector>

#include "source/kernel.h"
#include "source/node_positions.h"
#include "source/pixel_frame.h"
#include "source/pixel_reader.h"

namespace qmesh {

/// Turns pixels into node heights. A node is valid
///  - where its pixels are not reduced (both scales 1, or `nearest`): iff a valid pixel's closed
///  square
///    holds its position, to 1e-6 pixel, so that nodes on the raster's rim count;
///  - where they are: iff the raster's closed rectangle holds it and valid pixels make at least
///  half of
///    what the box of one node cell has of the raster.
/// Its height is the mean of the valid pixels of the kernel with their weights; where kernels with
/// negative lobes keep less than half of their weight, bilinear weights serve. Serves one thread.
class Interpolator {
 public:
  /// Scales: node spacing in pixels, 1 at least. `frame`: of the level that is read.
  Interpolator(Resampling resampling, double scaleX, double scaleY, const PixelFrame& frame);

  /// Pixels that a node may need on each side of its position.
  double radiusX() const { return radiusX_; }
  double radiusY() const { return radiusY_; }

  /// The pixels to read from; they must outlive the calls of run(). `bounds`: of all positions that
  /// will be asked for. REQUIRES: pixels outside `pixels` that a node needs do not exist.
  void use(const PixelWindow& pixels, const PixelBounds& bounds);

  /// Heights of `count` positions; NaN where void or where x is NaN.
  void run(const double* x, const double* y, int count, float* out);

 private:
  float byPixel(double x, double y) const;
  float bilinear(double x, double y) const;
  float general(double x, double y);
  float allValid(double x, double y);
  float weighted(const Kernel& kernelX, const Kernel& kernelY, double x, double y,
                 double& validWeight);
  void runBilinear(const double* x, const double* y, int count, float* out) const;
  bool surrounded(double x, double y) const;
  void fourPixels(const double* x, const double* y, int count, float* out) const;
  bool halfValid(double x, double y);
  bool insideRaster(double x, double y) const;
  float pixel(int column, int row) const;

  Resampling resampling_;
  bool reducing_;
  double scaleX_, scaleY_;
  PixelFrame frame_;
  Kernel kernelX_, kernelY_;
  Kernel tentX_, tentY_;
  double radiusX_, radiusY_;
  const PixelWindow* pixels_ = nullptr;
  bool allSurrounded_ = false; ///< the four pixels round every position are in the window
  Taps tapsX_, tapsY_, fullTapsY_;
  double tapsYFor_ = std::numeric_limits<double>::quiet_NaN(); ///< the row fullTapsY_ is for
  std::vector<double> columnSums_;
};

} // namespace qmesh
