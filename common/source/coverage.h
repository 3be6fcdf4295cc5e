// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include <gdal_priv.h>

namespace qmesh {

/// A rectangle of pixels of a band.
struct PixelRectangle {
  int column = 0;
  int row = 0;
  int width = 0;
  int height = 0;
};

/// Where a band may hold data, as rectangles that together cover all of it: the whole band unless
/// the format knows of holes (a VRT between its sources, blocks never written to a sparse file) and
/// holes are void. So two DEMs far apart cost their own area, not the box around them (promise P4).
/// Holes of less than 64 pixels, and in a band of very many holes larger ones, are not told.
std::vector<PixelRectangle> dataCoverage(GDALRasterBand& band);

} // namespace qmesh
