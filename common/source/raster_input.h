// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "base/status.h"
#include "source/coverage.h"
#include "source/dataset_access.h"
#include "source/height_options.h"
#include "source/input_options.h"
#include "source/pixel_frame.h"
#include "source/pixel_values.h"

namespace qmesh {

/// What is known about the input before a pixel is read, and the way to its pixels.
struct RasterInput {
  std::string path; ///< for messages
  DatasetAccess access;
  int band = 1;
  PixelFrame frame;
  OGRSpatialReference srs; ///< horizontal
  bool lonLat = false;     ///< longitude and latitude of WGS 84
  PixelValues values;
  std::size_t blockBytes = 0;           ///< of one block of the file, as GDAL holds it
  std::vector<PixelRectangle> coverage; ///< where there may be data
};

/// Opens the input of `options`, or looks at `host` where that is given (it must stay open), and
/// checks everything that can be checked without reading pixels. Code::input with the file, the
/// fault and the cure.
Result<RasterInput> describeRaster(const InputOptions& options, bool bathymetry, GDALDataset* host,
                                   std::vector<std::string>& warnings);

} // namespace qmesh
