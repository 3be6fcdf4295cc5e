// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "compare_run.h"

#include <cstdio>

#include "compare/compare.h"
#include "console/interrupt.h"
#include "run/make_terrain.h"
#include "vsi/png_file.h"
#include "vsi/vsi_files.h"

namespace qmesh {

namespace {

constexpr int kPictureWidth = 512;

/// The run whose last zoom has the tiles to compare on.
BuildOptions narrowed(const BuildOptions& options) {
  BuildOptions run = options;
  if (options.compare.tile) {
    const auto& [z, x, y] = *options.compare.tile;
    run.tiling.minZoom = run.tiling.maxZoom = z;
    run.tiling.minX = run.tiling.maxX = x;
    run.tiling.minY = run.tiling.maxY = y;
  }
  return run;
}

Status checkOutput(const BuildOptions& options) {
  const std::string& folder = options.output.path;
  if (pathExists(folder) && !isFolder(folder))
    return {Code::output, "'" + folder + "' is a file; the output must be a folder"};
  if (!options.output.overwrite && !listFolder(folder).empty())
    return {Code::output, "the output folder '" + folder +
                              "' is not empty; --overwrite replaces a comparison in it"};
  return makeFolders(folder);
}

Status writePictures(const std::string& folder, const Comparison& comparison) {
  for (const CompareTarget target : {CompareTarget::count, CompareTarget::error}) {
    for (const ComparedMethod& row : comparison.targets[std::size_t(target)]) {
      MeshDrawing drawing;
      drawing.width = kPictureWidth;
      const std::string file = folder + "/" + row.method + "-" + enumName(target) + ".png";
      QMESH_RETURN_IF_ERROR(writePng(file, paintMesh(row.mesh, drawing)));
    }
  }
  return {};
}

std::string titleLine(const BuildOptions& options, const Comparison& comparison) {
  const TileId& first = comparison.tiles.front();
  const std::string place =
      comparison.tiles.size() > 1
          ? std::to_string(comparison.tiles.size()) + " tiles of zoom " + std::to_string(first.z)
          : "tile " + std::to_string(first.z) + "/" + std::to_string(first.x) + "/" +
                std::to_string(first.y);
  return options.input.path + ": " + place + ", " + std::to_string(options.tiling.tileSize) +
         " cells an edge; what " + options.method.name + " makes is the measure";
}

} // namespace

Status runCompare(const BuildOptions& options, Console& console) {
  const BuildOptions run = narrowed(options);
  std::vector<std::string> warnings;
  const auto plan = planTerrain(run, nullptr, warnings);
  for (const std::string& warning : warnings)
    console.warning(warning);
  if (!plan.ok())
    return plan.status();
  QMESH_RETURN_IF_ERROR(checkOutput(run));
  const TilesetInput input{run, plan->pyramid, *plan->source};
  const auto tiles = chooseComparedTiles(input);
  if (!tiles.ok())
    return tiles.status();
  const auto comparison = compareMethods(input, *tiles, [&](double done) {
    console.progress(done);
    return !stopRequested();
  });
  if (!comparison.ok())
    return comparison.status();
  console.message(titleLine(run, *comparison));
  std::fputs(comparisonTable(*comparison).c_str(), stdout);
  const std::string csv = comparisonCsv(*comparison);
  QMESH_RETURN_IF_ERROR(
      writeWholeFile(run.output.path + "/comparison.csv", csv.data(), csv.size()));
  return writePictures(run.output.path, *comparison);
}

} // namespace qmesh
