// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/status.h"
#include "pyramid/block_plan.h"
#include "pyramid/blocks/block_scheduler.h"
#include "pyramid/report.h"
#include "sink/tile_sink.h"

namespace qmesh {

/// A text file that goes beside layer.json: name and content.
using SideFile = std::pair<std::string, std::string>;

/// Where a run writes.
struct TilesetOutput {
  TileSink& sink;
  std::string scratch; ///< folder on a local disk for temporary files
  std::vector<SideFile> sideFiles = {};
};

/// Makes every tile of the plan in the plan's threads, then the side files, then commits the
/// tileset with its layer.json. Any error, or `progress` returning false (Code::interrupted),
/// abandons the sink: nothing of the run is left and what was there before still is. The files are
/// the same whatever the block plan and the scheduler say.
Result<BuildReport> buildTileset(const TilesetInput& input, const BlockPlan& blocks,
                                 BlockScheduler& scheduler, const TilesetOutput& output,
                                 const Progress& progress);

/// The same with the blocks one after the other.
Result<BuildReport> buildTileset(const TilesetInput& input, const BlockPlan& blocks,
                                 const TilesetOutput& output, const Progress& progress);

} // namespace qmesh
