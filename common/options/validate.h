// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/build_options.h"

#include "base/status.h"

namespace qmesh {

/// What no row can check alone: options that contradict each other (Code::usage), and those that
/// go together oddly, as sentences added to `warnings`.
Status validate(const BuildOptions& options, std::vector<std::string>& warnings);

} // namespace qmesh
