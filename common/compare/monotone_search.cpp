// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "compare/monotone_search.h"

#include <cmath>

namespace qmesh {

namespace {

constexpr double kSmallestRatio = 1.0001;

/// How far an outcome is from the target, as a logarithm.
double missBy(double outcome, double target) {
  return std::abs(std::log(std::max(outcome, 1e-300) / target));
}

} // namespace

Result<SearchResult> searchMonotone(double low, double high, double target, double tolerance,
                                    const std::function<Result<double>(double)>& outcomeOf) {
  SearchResult best;
  const auto tryValue = [&](double value) -> Result<double> {
    auto outcome = outcomeOf(value);
    const bool better = outcome.ok() && (best.value == 0 ||
                                         missBy(*outcome, target) < missBy(best.outcome, target));
    if (better)
      best = {value, *outcome, std::abs(*outcome - target) <= tolerance * target};
    return outcome;
  };
  const auto first = tryValue(low);
  if (!first.ok())
    return first.status();
  const auto last = tryValue(high);
  if (!last.ok())
    return last.status();
  const bool rising = *last > *first;
  const bool between =
      rising ? *first <= target && target <= *last : *last <= target && target <= *first;
  while (between && !best.reached && high / low > kSmallestRatio) {
    const double middle = std::sqrt(low * high);
    const auto outcome = tryValue(middle);
    if (!outcome.ok())
      return outcome.status();
    ((*outcome < target) == rising ? low : high) = middle;
  }
  return best;
}

} // namespace qmesh
