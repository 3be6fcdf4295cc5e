// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/status.h"
#include "console/console.h"
#include "options/build_options.h"

namespace qmesh {

/// --compare: all methods on one tile or region; a table on stdout, comparison.csv and pictures in
/// the output folder. REQUIRES: GDAL's drivers are registered.
Status runCompare(const BuildOptions& options, Console& console);

} // namespace qmesh
