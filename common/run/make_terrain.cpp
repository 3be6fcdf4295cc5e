// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "run/make_terrain.h"

#include <algorithm>
#include <thread>

#include "sink/directory_sink.h"
#include "sink/zip_sink.h"
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
  auto source = openRasterSource(options, warnings, host);
  if (!source.ok())
    return source.status();
  plan.source = *std::move(source);
  auto pyramid = planPyramid(options, *plan.source);
  if (!pyramid.ok())
    return pyramid.status();
  plan.pyramid = *std::move(pyramid);
  auto blocks = planBlocks(options, plan.pyramid, plan.source->bytesPerSource(), processors());
  if (!blocks.ok())
    return blocks.status();
  plan.blocks = *std::move(blocks);
  return plan;
}

Result<std::unique_ptr<TileSink>> openTerrainSink(const BuildOptions& options) {
  return isZipPath(options.output) ? openZipSink(options) : openDirectorySink(options);
}

} // namespace qmesh
