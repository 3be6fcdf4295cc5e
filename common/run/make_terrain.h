// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "options/build_options.h"
#include "pyramid/tileset_builder.h"
#include "vsi/scratch_folder.h"

class GDALDataset;

namespace qmesh {

/// A run that may begin: the input is open, the pyramid and the work are planned.
struct TerrainPlan {
  std::shared_ptr<NodeSourceFactory> source;
  PyramidPlan pyramid;
  BlockPlan blocks;
};

/// Everything that can be found out before the work: opens the input of `options`, or uses `host`
/// (see openRasterSource), and plans. GDAL's block cache is left alone; blocks.cacheBytes is what
/// --memory has for it. `warnings` gets sentences.
Result<TerrainPlan> planTerrain(const BuildOptions& options, GDALDataset* host,
                                std::vector<std::string>& warnings);

/// The output that the options name, checked and ready.
struct TerrainOutput {
  std::unique_ptr<TileSink> sink;
  ScratchFolder scratch;
};
Result<TerrainOutput> openOutput(const BuildOptions& options);

/// Makes the tileset and puts it in place, as buildTileset(); meshes for --debug-meshes as well.
Result<BuildReport> makeTerrain(const BuildOptions& options, const TerrainPlan& plan,
                                TerrainOutput& output, const std::vector<SideFile>& sideFiles,
                                const Progress& progress);

} // namespace qmesh
