// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "run.h"

#include <filesystem>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include "compare_run.h"
#include "console/interrupt.h"
#include "preview.h"
#include "pyramid/estimate.h"
#include "run/make_terrain.h"
#include "summary.h"

namespace qmesh {

namespace {

/// Through VSI, so that --report may name any place GDAL can write.
Status writeReport(const std::string& file, const std::string& text) {
  VSILFILE* handle = VSIFOpenL(file.c_str(), "wb");
  const bool written = handle && VSIFWriteL(text.data(), 1, text.size(), handle) == text.size();
  const bool closed = handle && VSIFCloseL(handle) == 0;
  if (!written || !closed)
    return {Code::output, file + ": the report cannot be written"};
  return {};
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code none;
  return a == b || std::filesystem::equivalent(a, b, none);
}

/// Finds out before the work whether the report can be written; an existing one stays as it is.
Status checkReport(const BuildOptions& options) {
  const std::string& file = options.output.report;
  for (const std::string& read :
       {options.input.path, options.input.cutline, options.run.configFile}) {
    if (isSameFile(file, read))
      return {Code::usage, "--report " + file + " is a file this run reads; name another one"};
  }
  VSIStatBufL info;
  const bool exists = VSIStatL(file.c_str(), &info) == 0;
  VSILFILE* handle = VSIFOpenL(file.c_str(), exists ? "r+b" : "wb");
  if (!handle)
    return {Code::output, file + ": the report cannot be written there"};
  VSIFCloseL(handle);
  if (!exists)
    VSIUnlink(file.c_str());
  return {};
}

std::vector<SideFile> sideFiles(const BuildOptions& options) {
  std::vector<SideFile> files;
  if (options.output.preview == Preview::none)
    return files;
  for (const PreviewFile& file : previewFiles(options))
    files.emplace_back(file.name, file.text);
  return files;
}

Status dryRun(const BuildOptions& options, const TerrainPlan& plan, Console& console) {
  const auto estimate = estimateRun({options, plan.pyramid, *plan.source}, plan.blocks);
  if (!estimate.ok())
    return estimate.status();
  std::fputs(estimateTable(plan.pyramid, plan.blocks, *estimate).c_str(), stdout);
  console.detail("nothing was written");
  return {};
}

Status build(const BuildOptions& options, const TerrainPlan& plan, Console& console) {
  if (!options.output.report.empty())
    QMESH_RETURN_IF_ERROR(checkReport(options));
  auto output = openOutput(options);
  if (!output.ok())
    return output.status();
  console.message(startLine(options, plan.pyramid, plan.blocks));
  const auto report = makeTerrain(options, plan, *output, sideFiles(options), [&](double done) {
    console.progress(done);
    return !stopRequested();
  });
  if (!report.ok())
    return report.status();
  if (!options.output.cesium.empty())
    QMESH_RETURN_IF_ERROR(copyCesium(options.output.cesium, options.output.path));
  if (!options.output.report.empty())
    QMESH_RETURN_IF_ERROR(writeReport(options.output.report, reportJson(*report)));
  for (const std::string& warning : reportWarnings(*report))
    console.warning(warning);
  for (const std::string& line : reportLines(options, *report))
    console.message(line);
  if (options.run.verbose)
    console.detail(levelTable(*report));
  return {};
}

} // namespace

Status runBuild(const BuildOptions& options, Console& console) {
  GDALAllRegister();
  if (options.compare.enabled)
    return runCompare(options, console);
  if (!options.output.cesium.empty()) {
    const auto found = findCesium(options.output.cesium);
    if (!found.ok())
      return found.status();
  }
  std::vector<std::string> warnings;
  const auto plan = planTerrain(options, nullptr, warnings);
  for (const std::string& warning : warnings)
    console.warning(warning);
  if (!plan.ok())
    return plan.status();
  GDALSetCacheMax64(GIntBig(plan->blocks.cacheBytes));
  return options.run.dryRun ? dryRun(options, *plan, console) : build(options, *plan, console);
}

} // namespace qmesh
