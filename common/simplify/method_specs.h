// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "simplify/method_options.h"

namespace qmesh {

/// One LevelSpec of the methods: its name as an option and the values it takes.
struct MethodSpec {
  const char* name; ///< without dashes
  LevelSpec MethodOptions::*field;
  const char* unit;              ///< empty: none
  std::optional<double> minimum; ///< inclusive; nothing: 0
  std::optional<double> maximum; ///< inclusive; nothing: no limit

  /// "1 to 5 m", "1 or more", "m", or nothing.
  std::string rangeText() const;
};

/// All of them, in the order of the help.
const std::vector<MethodSpec>& methodSpecs();

/// REQUIRES: there is one of that name.
const MethodSpec& methodSpec(std::string_view name);

/// Each one that is set has a value within its range at the zooms first..last; else Code::usage
/// with the option's name. What maxError overrides does not count.
Status checkSpecs(const MethodOptions& options, int first, int last);

} // namespace qmesh
