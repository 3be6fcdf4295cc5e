// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "options/build_options.h"
#include "pyramid/block_plan.h"
#include "sink/tile_sink.h"

class GDALDataset;

namespace qmesh {

/// A run that may begin: the input is open, the pyramid and the work are planned.
struct TerrainPlan {
  std::shared_ptr<NodeSourceFactory> source;
  PyramidPlan pyramid;
  BlockPlan blocks;
};

/// Everything that can be found out before the work, the same for every door: opens the input of
/// `options`, or uses `host` (see openRasterSource), and plans. GDAL's block cache is left alone;
/// blocks.cacheBytes is what --memory has for it. `warnings` gets sentences.
Result<TerrainPlan> planTerrain(const BuildOptions& options, GDALDataset* host,
                                std::vector<std::string>& warnings);

/// The place options.output names, checked and ready: with it and the plan buildTileset() does the
/// work. A zip archive where the name is below /vsizip/ (zip_sink.h), else a folder
/// (directory_sink.h).
Result<std::unique_ptr<TileSink>> openTerrainSink(const BuildOptions& options);

} // namespace qmesh
