// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/build_options.h"
#include "pyramid/block_plan.h"
#include "pyramid/estimate.h"
#include "pyramid/report.h"

/// What the command tells of a run, in words.
namespace qmesh {

/// "bigtujunga.tif -> out: zooms 0-12, 70 tiles, method greedy, 2 threads".
std::string startLine(const BuildOptions& options, const PyramidPlan& plan,
                      const BlockPlan& blocks);

/// What was made, where it is and how to look at it.
std::vector<std::string> reportLines(const BuildOptions& options, const BuildReport& report);

/// One line a zoom: tiles, triangles, bytes, errors.
std::string levelTable(const BuildReport& report);

/// --dry-run: one line a zoom, then the total.
std::string estimateTable(const PyramidPlan& plan, const BlockPlan& blocks,
                          const Estimate& estimate);

} // namespace qmesh
