// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/tileset_builder.h"

#include "base/stopwatch.h"
#include "pyramid/inherit_runner.h"
#include "pyramid/layer_record.h"
#include "pyramid/stage_runner.h"

namespace qmesh {

namespace {

Status makeTiles(BuildShared& shared, const BlockPlan& blocks, const std::string& scratch,
                 const Progress& progress) {
  WorkTeam team(shared.stop, progress, [&] { shared.source.enterThread(); });
  StageRunner stages(shared, blocks, team, scratch);
  if (shared.options.border == BorderMode::inherit)
    return InheritRunner(shared, blocks, team, stages).run();
  return stages.run();
}

BuildReport makeReport(const BuildShared& shared, const BlockPlan& blocks) {
  const PyramidPlan& plan = shared.plan;
  BuildReport report;
  report.input = shared.options.input;
  report.output = shared.options.output;
  report.method = shared.options.method;
  report.minZoom = plan.minZoom;
  report.maxZoom = plan.maxZoom;
  report.cellsPerTile = plan.cells;
  for (const LevelParams& level : plan.levels)
    report.maxErrors.push_back(level.maxError);
  report.levels = shared.levels;
  report.seconds = shared.seconds;
  report.threads = blocks.threads;
  report.blockTiles = blocks.blockTiles;
  report.contentHash = shared.contentHash;
  report.anyData = shared.anyData;
  return report;
}

Result<BuildReport> buildAndCommit(BuildShared& shared, const BlockPlan& blocks,
                                   const std::vector<SideFile>& sideFiles,
                                   const Progress& progress) {
  Stopwatch watch;
  const auto scratch = shared.sink.scratchFolder();
  if (!scratch.ok())
    return scratch.status();
  QMESH_RETURN_IF_ERROR(makeTiles(shared, blocks, *scratch, progress));
  for (const SideFile& file : sideFiles) {
    QMESH_RETURN_IF_ERROR(shared.sink.writeFile(file.first, file.second));
  }
  BuildReport report = makeReport(shared, blocks);
  const LayerJson layer = layerRecord(shared.options, shared.plan, shared.written, report);
  QMESH_RETURN_IF_ERROR(shared.sink.commit(writeLayerJson(layer)));
  report.wallSeconds = watch.lap();
  if (progress)
    progress(1);
  return report;
}

} // namespace

Result<BuildReport> buildTileset(const TilesetInput& input, const BlockPlan& blocks, TileSink& sink,
                                 const std::vector<SideFile>& sideFiles, const Progress& progress) {
  BuildShared shared(input, sink);
  auto report = buildAndCommit(shared, blocks, sideFiles, progress);
  if (!report.ok())
    sink.abandon();
  return report;
}

} // namespace qmesh
