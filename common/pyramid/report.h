// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace qmesh {

/// The steps whose time is told apart.
enum class Step { sample, reduce, mesh, encode, write };
inline constexpr int kStepCount = 5;
inline constexpr std::array<const char*, kStepCount> kStepNames = {"sample", "reduce", "mesh",
                                                                   "encode", "write"};

using StepSeconds = std::array<double, kStepCount>; ///< summed over threads

/// What became of the tiles of a level. Sums are integers, so that they do not depend on the order
/// in which threads add to them.
struct LevelStats {
  std::uint64_t tiles = 0;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t bytes = 0;             ///< as stored
  std::uint64_t nodes = 0;             ///< that the errors were measured at
  double maxError = 0;                 ///< metres, reached
  std::uint64_t sumSquaredError = 0;   ///< thousandths of a square metre
  std::uint64_t quantizationTiles = 0; ///< rounding alone exceeds the max error
  std::uint64_t coarseTiles = 0;       ///< range exceeds the height lattice
  double largestCoarseStep = 0;        ///< metres

  void add(const LevelStats& other);
  double rmsError() const;
};

/// What a run did: --report writes it, the commands print from it.
struct BuildReport {
  std::string input;
  std::string output;
  std::string method;
  int minZoom = 0;
  int maxZoom = 0;
  int cellsPerTile = 0;
  std::vector<double> maxErrors;  ///< asked for, by zoom from 0
  std::vector<LevelStats> levels; ///< by zoom from 0
  StepSeconds seconds{};
  double wallSeconds = 0;
  int threads = 0;
  int blockTiles = 0;
  bool anyData = true;           ///< a node of the finest level got a height from the input
  std::uint64_t contentHash = 0; ///< of every tile, in any order

  LevelStats total() const;
};

/// Promises that did not hold somewhere, each a sentence with the number of tiles.
std::vector<std::string> reportWarnings(const BuildReport& report);

/// The report as one JSON object; docs/gdal2qmesh.md names its keys.
std::string reportJson(const BuildReport& report);

} // namespace qmesh
