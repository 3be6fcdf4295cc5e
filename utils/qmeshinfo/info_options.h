// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "export/export_choices.h"
#include "options/option_structs.h"
#include "options/option_table.h"
#include "options/parse.h"
#include "pyramid/run_options.h"
#include "source/height_options.h"
#include "source/input_options.h"

namespace qmesh {

/// The options of qmeshinfo. How the DEM of --dem is read is said as to gdal2qmesh, by the same
/// structs and rows.
struct InfoOptions {
  std::string set;                     ///< folder, layer.json, tile or URL
  std::optional<int> minZoom, maxZoom; ///< the zooms looked at; unset: all

  // What is said
  bool json = false;
  bool stats = false;
  bool validate = false;
  int maxFindings = 10;            ///< printed a code; 0: all
  std::vector<std::string> ignore; ///< codes of findings not wanted

  // Against a DEM
  InputOptions dem; ///< no path: none
  HeightOptions heights;
  int demStep = 0;         ///< 0: chosen by the size of the DEM
  std::string errorRaster; ///< GeoTIFF to write

  // One tile
  std::optional<TileId> tile;
  std::string exportFile;
  MeshFrame frame = MeshFrame::local;
  std::string drawing;
  MeshShade shade = MeshShade::height;
  int drawingWidth = 1024; ///< pixels

  std::vector<std::string> samples; ///< LON,LAT or "-"

  RunOptions run;

  operator OptionStructs() { return OptionStructs::of(*this, dem, heights, run); } // NOLINT
  operator ConstOptionStructs() const {                                            // NOLINT
    return ConstOptionStructs::of(*this, dem, heights, run);
  }
};

/// The options and texts of qmeshinfo.
OptionTable infoTable();

/// A command line of qmeshinfo, understood.
struct InfoCommandLine {
  Request request = Request::run;
  InfoOptions options;               ///< complete and checked where request is run
  std::vector<std::string> warnings; ///< sentences without "warning:"
};

/// Code::usage with one sentence where something is unknown, malformed or contradicts.
Result<InfoCommandLine> parseInfoCommandLine(const OptionTable& table,
                                             const std::vector<std::string>& words);

/// "LON,LAT" in degrees, blanks allowed around and instead of the comma; longitude -360..360,
/// latitude -90..90. Code::usage naming the text where it is none.
Result<std::array<double, 2>> parseLonLat(const std::string& text);

} // namespace qmesh
