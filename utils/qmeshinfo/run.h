// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "console/console.h"
#include "qmeshinfo/info_options.h"

namespace qmesh {

/// What a run says on standard output, and whether it found an error.
struct InfoResult {
  std::string text;
  bool foundError = false;
};

/// Does all that was asked for. Progress goes to the console.
Result<InfoResult> runInfo(const InfoOptions& options, Console& console);

} // namespace qmesh
