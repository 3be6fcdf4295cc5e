// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "run/make_terrain.h"

#include <algorithm>
#include <thread>

#include "sink/mesh_files.h"
#include "sink/sink_types.h"
#include "source/raster_source.h"

namespace qmesh {
namespace {

int processors() {
  return int(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace

Result<TerrainPlan> planTerrain(const BuildOptions& options, GDALDataset* host,
                                std::vector<std::string>& warnings) {
  TerrainPlan plan;
  auto source = openRasterSource(options.input, options.heights, warnings, host);
  if (!source.ok())
    return source.status();
  plan.source = *std::move(source);
  auto pyramid = planPyramid(options, *plan.source);
  if (!pyramid.ok())
    return pyramid.status();
  plan.pyramid = *std::move(pyramid);
  auto blocks =
      planBlocks(options, options.run, plan.pyramid, plan.source->bytesPerSource(), processors());
  if (!blocks.ok())
    return blocks.status();
  plan.blocks = *std::move(blocks);
  return plan;
}

Result<TerrainOutput> openOutput(const BuildOptions& options) {
  auto opened = openSink(options.output);
  if (!opened.ok())
    return opened.status();
  auto scratch = ScratchFolder::make(opened->workFolder);
  if (!scratch.ok())
    return scratch.status();
  return TerrainOutput{std::move(opened->sink), *std::move(scratch)};
}

Result<BuildReport> makeTerrain(const BuildOptions& options, const TerrainPlan& plan,
                                TerrainOutput& output, const std::vector<SideFile>& sideFiles,
                                const Progress& progress) {
  return buildTileset({options, plan.pyramid, *plan.source, meshFiles(options.output)}, plan.blocks,
                      {*output.sink, output.scratch.path(), sideFiles}, progress);
}

} // namespace qmesh
