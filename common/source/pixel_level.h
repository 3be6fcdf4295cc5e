// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <gdal_priv.h>

#include "source/pixel_frame.h"

namespace qmesh {

/// Which pixels a lattice is sampled from: those of the band, or of one of its overviews, and of
/// these the mean of blocks of blockX x blockY, anchored at pixel (0, 0). Chosen once per lattice,
/// so that sampling stays a pure function of the node.
struct PixelLevel {
  int overview = -1; ///< -1: the band itself
  int sourceColumns = 0;
  int sourceRows = 0;
  int blockX = 1; ///< powers of two
  int blockY = 1;
  double factorX = 1; ///< columns of the band in one pixel of the level
  double factorY = 1;

  int columns() const { return (sourceColumns + blockX - 1) / blockX; }
  int rows() const { return (sourceRows + blockY - 1) / blockY; }

  /// The band as it is.
  static PixelLevel full(const PixelFrame& frame);

  /// For nodes scaleX x scaleY pixels apart: from 8 pixels on, the coarsest overview with at least
  /// two pixels per node, then blocks that leave 4 to 8.
  static PixelLevel choose(GDALRasterBand& band, const PixelFrame& frame, double scaleX,
                           double scaleY);
};

} // namespace qmesh
