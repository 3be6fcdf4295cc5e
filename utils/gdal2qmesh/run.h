// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/status.h"
#include "console/console.h"
#include "options/build_options.h"

namespace qmesh {

/// Does what the options say, from the DEM to the finished folder (or the estimate of --dry-run),
/// and tells the user on the way.
Status runBuild(const BuildOptions& options, Console& console);

} // namespace qmesh
