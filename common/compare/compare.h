// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "mesh/tin_quality.h"
#include "pyramid/pyramid_plan.h"

namespace qmesh {

/// What the methods of a comparison have in common.
enum class CompareTarget { defaults, count, error };

template <> struct EnumTable<CompareTarget> {
  static constexpr EnumRow<CompareTarget> kRows[] = {
      {CompareTarget::defaults, "defaults", "every method with the run's options"},
      {CompareTarget::count, "count", "the triangle count of --method"},
      {CompareTarget::error, "error", "the max error that --method reaches"},
  };
};

/// One method at one target. Sums are over the tiles.
struct ComparedMethod {
  std::string method;
  std::string option; ///< that was tuned; empty: none
  std::string value;  ///< of it
  bool reached = true;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t bytes = 0; ///< as stored
  TinQuality quality;
  double cpuSeconds = 0; ///< of border and triangulation, this once
  ExportMesh mesh;       ///< of all tiles
};

/// The methods of this build on the same nodes.
struct Comparison {
  std::vector<TileId> tiles;
  std::uint64_t triangles = 0;                        ///< of --method with the run's options
  double maxError = 0;                                ///< metres, that it reached
  std::array<std::vector<ComparedMethod>, 3> targets; ///< by CompareTarget, methods in the order
                                                      ///< of the help
};

/// The tiles of the plan's last zoom to compare on: all of them where the user limited them by
/// --min-x and so on (Code::usage where these are more than kMostComparedTiles), else the one
/// with the most triangles by --method, of up to kTilesLookedAt spread over the level.
Result<std::vector<TileId>> chooseComparedTiles(const TilesetInput& input);
inline constexpr std::uint64_t kMostComparedTiles = 64;
inline constexpr std::uint64_t kTilesLookedAt = 64;

/// Every method of this build at every target: the option that decides how many triangles a method
/// makes (SimplifierInfo::mainOption) is searched for on a logarithmic scale; where the max error
/// is the target, --max-error is tried as well. A method that cannot reach the target, or has no
/// such option, says so and shows what comes nearest. Borders are those of --border shared. One
/// thread.
Result<Comparison> compareMethods(const TilesetInput& input, const std::vector<TileId>& tiles,
                                  const Progress& progress);

/// Three tables for people; the only place where CPU time is told.
std::string comparisonTable(const Comparison& comparison);

/// All numbers but times, a line a method and target, with a header line: the same at every run.
std::string comparisonCsv(const Comparison& comparison);

} // namespace qmesh
