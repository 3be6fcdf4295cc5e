// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>

#include "grid/void_fill.h"

namespace qmesh {

/// Heights beyond these (metres) are no terrain.
inline constexpr double kLowestHeight = -100000;
inline constexpr double kHighestHeight = 100000;

/// What is done to the heights of the DEM.
struct HeightOptions {
  bool bathymetry = false;                 ///< depths, positive down
  std::optional<double> clipLow, clipHigh; ///< metres
  double scaleAbove = 1, scaleBelow = 1;   ///< above and below 0, before clipping
  VoidFill voidFill = VoidFill::value;
  double voidValue = 0; ///< metres
};

} // namespace qmesh
