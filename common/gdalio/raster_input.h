// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "base/status.h"
#include "gdalio/coverage.h"
#include "gdalio/pixel_frame.h"
#include "gdalio/pixel_values.h"
#include "options/build_options.h"

namespace qmesh {

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const;
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

/// What is known about the input before a pixel is read: enough to open it again for each thread.
struct RasterInput {
  std::string path;
  std::vector<std::string> formats;     ///< --if
  std::vector<std::string> openOptions; ///< --oo
  int band = 1;
  PixelFrame frame;
  OGRSpatialReference srs; ///< horizontal
  bool lonLat = false;     ///< longitude and latitude of WGS 84
  PixelValues values;
  std::size_t blockBytes = 0;           ///< of one block of the file, as GDAL holds it
  std::vector<PixelRectangle> coverage; ///< where there may be data

  /// Opens the dataset once more, sharing nothing with the others.
  Result<DatasetPtr> reopen() const;
};

/// Opens the input of `options` and checks everything that can be checked without reading pixels.
/// Code::input with the file, the fault and the cure.
Result<RasterInput> describeRaster(const BuildOptions& options, std::vector<std::string>& warnings);

} // namespace qmesh
