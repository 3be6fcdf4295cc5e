// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "options/export_choices.h"
#include "options/method_options.h"
#include "options/option_values.h"

namespace qmesh {

/// The deepest zoom an option takes: tiling's kMaxZoom, which this folder may not include.
inline constexpr int kDeepestZoom = 24;

/// Everything a user can say about a run. Defaults are the initialisers; the rows of
/// options/option_rows.cpp name each field once and feed the command line, the help, the JSON and
/// the reference pages.
struct BuildOptions : OptionValues, MethodOptions {
  std::string input;
  std::string output; ///< empty: the input's base name in the current folder

  // Reading
  std::string sourceSrs;                       ///< -s; empty: the input's own
  std::vector<std::string> openOptions;        ///< --oo
  std::vector<std::string> inputFormats;       ///< --if
  int band = 1;                                ///< -b
  std::optional<double> sourceNodata;          ///< -a
  std::optional<std::array<double, 4>> extent; ///< --te
  std::string extentSrs;                       ///< --te-srs; empty: the input's
  std::string cutline;                         ///< --cutline
  Resampling resampling = Resampling::bilinear;
  OverviewResampling overviewResampling = OverviewResampling::average;

  // Heights
  bool bathymetry = false;                 ///< depths positive down
  std::optional<double> clipLow, clipHigh; ///< metres
  double scaleAbove = 1, scaleBelow = 1;   ///< above / below sea level
  VoidFill voidFill = VoidFill::value;
  double voidValue = 0; ///< metres

  // Tiling
  ProfileChoice profile = ProfileChoice::geodetic;
  std::optional<int> minZoom, maxZoom;                ///< unset: 0 and native
  std::optional<std::int64_t> minX, maxX, minY, maxY; ///< tiles at the maximum zoom
  int tileSize = 256;                                 ///< cells per edge
  bool excludeVoid = false;                           ///< -x

  // What a tile holds beside its triangles
  bool normals = true;
  int metadata = 0; ///< 0: no metadata extension

  // Output
  bool xyz = false;
  Compression compression = Compression::gzip;
  bool overwrite = false;
  Preview preview = Preview::none;
  std::string cesium; ///< --cesium DIR
  std::string title;
  std::string copyright;
  std::string report;      ///< JSON file
  std::string debugMeshes; ///< folder; empty: none
  MeshFormat debugFormat = MeshFormat::ply;

  // Running
  std::string configFile; ///< already read when a parser returns
  int threads = 0;        ///< 0: ALL_CPUS
  std::uint64_t memoryBytes = 512ull << 20;
  int blockTiles = 0; ///< 0: by memory and threads; else 2, 4, 8
  bool dryRun = false;
  bool compare = false;                                   ///< methods instead of a run
  std::optional<std::array<std::int64_t, 3>> compareTile; ///< zoom, column, row from the south
  bool quiet = false;
  bool verbose = false;
};

} // namespace qmesh
