// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/tileset_builder.h"

#include "base/stopwatch.h"
#include "pyramid/blocks/stage_runner.h"
#include "pyramid/inherit/inherit_runner.h"
#include "pyramid/layer_record.h"

namespace qmesh {

namespace {

Status makeTiles(StageRunner& stages, const RunContext& context, const BlockPlan& blocks,
                 WorkTeam& team) {
  if (context.options().tiling.border == BorderMode::inherit)
    return InheritRunner(context, blocks, team, stages).run();
  return stages.run();
}

BuildReport makeReport(const TilesetInput& input, const BlockPlan& blocks,
                       const BlockResult& totals) {
  const PyramidPlan& plan = input.plan;
  BuildReport report;
  report.input = input.options.input.path;
  report.output = input.options.output.path;
  report.method = input.options.method.name;
  report.minZoom = plan.minZoom;
  report.maxZoom = plan.maxZoom;
  report.cellsPerTile = plan.cells;
  for (const LevelParams& level : plan.levels)
    report.maxErrors.push_back(level.maxError);
  report.levels = totals.levels;
  report.levels.resize(plan.levels.size());
  report.seconds = totals.seconds;
  report.threads = blocks.threads;
  report.blockTiles = blocks.blockTiles;
  report.contentHash = totals.contentHash;
  report.anyData = totals.anyData;
  return report;
}

Result<BuildReport> buildAndCommit(const TilesetInput& input, const BlockPlan& blocks,
                                   BlockScheduler& scheduler, const TilesetOutput& output,
                                   const Progress& progress) {
  Stopwatch watch;
  RunControl control;
  const RunContext context{input, output.sink, control};
  WorkTeam team(control.stop, progress, [&] { input.source.enterThread(); });
  StageRunner stages(context, blocks, scheduler, team, output.scratch);
  QMESH_RETURN_IF_ERROR(makeTiles(stages, context, blocks, team));
  for (const SideFile& file : output.sideFiles)
    QMESH_RETURN_IF_ERROR(output.sink.writeFile(file.first, file.second));
  const BlockResult totals = stages.totals().get();
  BuildReport report = makeReport(input, blocks, totals);
  const LayerJson layer = layerRecord(input.options, input.plan, totals.kept, report);
  QMESH_RETURN_IF_ERROR(output.sink.commit(writeLayerJson(layer)));
  report.wallSeconds = watch.lap();
  if (progress)
    progress(1);
  return report;
}

} // namespace

Result<BuildReport> buildTileset(const TilesetInput& input, const BlockPlan& blocks,
                                 BlockScheduler& scheduler, const TilesetOutput& output,
                                 const Progress& progress) {
  auto report = buildAndCommit(input, blocks, scheduler, output, progress);
  if (!report.ok())
    output.sink.abandon();
  return report;
}

Result<BuildReport> buildTileset(const TilesetInput& input, const BlockPlan& blocks,
                                 const TilesetOutput& output, const Progress& progress) {
  SequentialScheduler scheduler;
  return buildTileset(input, blocks, scheduler, output, progress);
}

} // namespace qmesh
