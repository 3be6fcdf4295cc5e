// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <optional>

#include "grid/reduce.h"
#include "pyramid/inherit/schedule.h"
#include "tiling/scheme.h"

namespace qmesh {

inline constexpr int kSmallestTile = 8;
inline constexpr int kLargestTile = 1024;

/// Which tiles are made, in which order, and how coarser levels get their nodes.
struct TilingOptions {
  Profile profile = Profile::geodetic;
  std::optional<int> minZoom, maxZoom;                ///< unset: 0 and native
  std::optional<std::int64_t> minX, maxX, minY, maxY; ///< tiles at the maximum zoom
  int tileSize = 256; ///< cells per edge, a power of two, kSmallestTile..kLargestTile
  bool excludeVoid = false;
  OverviewResampling overviewResampling = OverviewResampling::average;
  BorderMode border = BorderMode::shared;
  Schedule schedule = Schedule::fourColour; ///< of BorderMode::inherit
};

} // namespace qmesh
