// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.h"
#include "source/height_options.h"
#include "source/input_options.h"
#include "tileset/tileset.h"

namespace qmesh {

/// How far a level's surface is from the DEM's cells, metres.
struct LevelError {
  int zoom = 0;
  std::uint64_t cells = 0;     ///< compared
  std::uint64_t uncovered = 0; ///< with a height, where the level has no surface
  double max = 0;              ///< largest |surface - DEM|
  double maxLon = 0, maxLat = 0;
  double mean = 0; ///< of surface - DEM: above 0 where the terrain is too high
  double rms = 0;
  double p99 = 0; ///< 99 % of the cells are within it
};

struct DemReport {
  std::string file;
  int step = 1;
  std::uint64_t cells = 0; ///< of the DEM looked at, voids included
  std::uint64_t voids = 0;
  std::vector<LevelError> levels;
};

/// What to measure, and how.
struct MeasurePlan {
  int firstZoom = 0, lastZoom = 0;
  int threads = 1;
  int step = 0;            ///< every so many cells of a row and a column; 0: by the size of the DEM
  std::string errorRaster; ///< GeoTIFF to write; empty: none
};

/// Compares the surface of each zoom of the plan that has tiles with the DEM `input`
/// (read as gdal2qmesh reads it) at the centres of its cells, every `step`-th. The errors are
/// the same for any number of threads. With `errorRaster` the deepest of these zooms is written
/// there. p99 is over all cells, or a regular part of them where there are more than 2 million.
/// Code::input, Code::output or Code::interrupted.
Result<DemReport> measureAgainstDem(const Tileset& set, const MeasurePlan& plan,
                                    const InputOptions& input, const HeightOptions& heights,
                                    std::vector<std::string>& warnings, const Progress& progress);

} // namespace qmesh
