// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>

#include "base/status.h"

namespace qmesh {

/// What a search found.
struct SearchResult {
  double value = 0;     ///< the best argument tried
  double outcome = 0;   ///< of it
  bool reached = false; ///< within the tolerance
};

/// Looks for the argument whose outcome is `target` (> 0) by bisection on the logarithm of a
/// multiplier: arguments low..high (0 < low < high) where the outcome goes one way, up or down; a
/// little noise and steps do no harm. Stops within `tolerance` (a share of the target) or where the
/// arguments differ by less than a ten-thousandth; the best one tried counts.
Result<SearchResult> searchMonotone(double low, double high, double target, double tolerance,
                                    const std::function<Result<double>(double)>& outcomeOf);

} // namespace qmesh
