// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/raster_input.h"

namespace qmesh {

/// A GeoTIFF of float32 numbers, NaN for none, whose pixels are `step` x `step` cells of a DEM.
class ErrorRaster {
 public:
  static Result<ErrorRaster> create(const std::string& path, const RasterInput& dem, int step,
                                    int columns, int rows);

  /// Numbers of a rectangle, row by row from the top.
  Status write(int column, int row, int width, int height, std::vector<float>& numbers);
  /// Code::output when the file is not complete on its disk.
  Status close();

 private:
  ErrorRaster(std::string path, DatasetPtr file) : path_(std::move(path)), file_(std::move(file)) {}

  std::string path_;
  DatasetPtr file_;
};

} // namespace qmesh
