// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "source/kernel.h"

namespace qmesh {

/// Which DEM is read, and how.
struct InputOptions {
  std::string path;
  std::string sourceSrs; ///< empty: the raster's own
  std::vector<std::string> openOptions;
  std::vector<std::string> inputFormats; ///< GDAL drivers; empty: all
  int band = 1;
  std::optional<double> sourceNodata;          ///< unset: the band's own
  std::optional<std::array<double, 4>> extent; ///< west, south, east, north in extentSrs
  std::string extentSrs;                       ///< empty: that of the raster
  std::string cutline;                         ///< vector file; empty: none
  Resampling resampling = Resampling::bilinear;
};

} // namespace qmesh
