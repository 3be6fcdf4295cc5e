// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "run.h"

#include <algorithm>
#include <thread>

#include <gdal.h>

#include "console/interrupt.h"
#include "info_report.h"

namespace qmesh {

namespace {

int threadsOf(const InfoOptions& options) {
  return options.run.threads > 0 ? options.run.threads
                                 : std::max(1, int(std::thread::hardware_concurrency()));
}

Result<std::set<int>> ignoredCodes(const InfoOptions& options) {
  std::set<int> codes;
  for (const std::string& text : options.ignore) {
    const int code = codeOf(text);
    if (code == 0)
      return Status(Code::usage,
                    "--ignore " + text + ": there is no such finding; --list-findings lists them");
    codes.insert(code);
  }
  return codes;
}

/// The work on one set.
class InfoRun {
 public:
  InfoRun(const InfoOptions& options, OpenedTileset& opened, Console& console)
      : options_(options), opened_(opened), set_(opened.set), console_(console),
        firstZoom_(options.minZoom.value_or(0)),
        lastZoom_(std::min(options.maxZoom.value_or(kMaxZoom), std::max(0, set_.maxZoom()))) {
    report_.path = options.set;
    report_.set = &set_;
  }

  Status run(FindingCounts& book) {
    QMESH_RETURN_IF_ERROR(checkZooms());
    QMESH_RETURN_IF_ERROR(describeOne());
    if (options_.stats || options_.validate)
      QMESH_RETURN_IF_ERROR(survey(book));
    if (!options_.dem.path.empty())
      QMESH_RETURN_IF_ERROR(measure());
    if (!options_.samples.empty())
      QMESH_RETURN_IF_ERROR(sample());
    const bool other = report_.tile || report_.dem || report_.samples;
    report_.describe = !set_.singleTile() && (options_.stats || options_.validate || !other);
    return {};
  }

  const InfoReport& report() const { return report_; }

 private:
  Progress progress() {
    return [this](double done) {
      console_.progress(done);
      return !stopRequested();
    };
  }

  /// At least one of the zooms asked for is there.
  Status checkZooms() const {
    const int deepest = set_.available().maxZoom();
    if (set_.singleTile() || deepest < 0 || firstZoom_ <= std::max(deepest, set_.maxZoom()))
      return {};
    return {Code::usage, "-z: '" + options_.set + "' has no zoom " + std::to_string(firstZoom_) +
                             "; its deepest is " + std::to_string(deepest)};
  }

  Status describeOne() {
    if (!options_.tile && !set_.singleTile())
      return {};
    TileId tile = set_.singleTile().value_or(TileId());
    if (options_.tile)
      tile = *options_.tile;
    Result<TileReport> described = describeTile(set_, tile);
    // A tile that is to be validated may be one that cannot be decoded.
    if (!described.ok() && set_.singleTile() && options_.validate)
      return {};
    if (!described.ok())
      return described.status();
    report_.tile = *std::move(described);
    return exportTile(*report_.tile, options_);
  }

  Status survey(FindingCounts& book) {
    SurveyPlan plan;
    plan.firstZoom = firstZoom_;
    plan.lastZoom = lastZoom_;
    plan.threads = threadsOf(options_);
    plan.book = options_.validate ? &book : nullptr;
    Result<Survey> survey = surveyTileset(opened_, plan, progress());
    if (!survey.ok())
      return survey.status();
    report_.survey = *std::move(survey);
    report_.book = plan.book;
    return {};
  }

  Status measure() {
    std::vector<std::string> warnings;
    const MeasurePlan plan{firstZoom_, lastZoom_, threadsOf(options_), options_.demStep,
                           options_.errorRaster};
    Result<DemReport> dem =
        measureAgainstDem(set_, plan, options_.dem, options_.heights, warnings, progress());
    for (const std::string& warning : warnings)
      console_.warning(warning);
    if (!dem.ok())
      return dem.status();
    report_.dem = *std::move(dem);
    return {};
  }

  Status sample() {
    Result<std::vector<Sample>> samples = samplePlaces(set_, lastZoom_, options_.samples);
    if (!samples.ok())
      return samples.status();
    report_.samples = *std::move(samples);
    return {};
  }

  const InfoOptions& options_;
  OpenedTileset& opened_;
  const Tileset& set_;
  Console& console_;
  int firstZoom_, lastZoom_;
  InfoReport report_;
};

} // namespace

Result<InfoResult> runInfo(const InfoOptions& options, Console& console) {
  const Result<std::set<int>> ignored = ignoredCodes(options);
  if (!ignored.ok())
    return ignored.status();
  GDALAllRegister();
  Result<OpenedTileset> opened = openTileset(options.set);
  if (!opened.ok())
    return opened.status();
  if (!options.validate)
    for (const Finding& finding : opened->layerFindings)
      if (findingKind(finding.code).severity == Severity::error)
        console.warning(codeText(finding.code) + ": " + findingKind(finding.code).title +
                        (finding.what.empty() ? "" : ": " + finding.what) +
                        " (--validate tells more)");
  FindingCounts book(std::size_t(options.maxFindings), *ignored);
  InfoRun run(options, *opened, console);
  QMESH_RETURN_IF_ERROR(run.run(book));
  InfoResult result;
  result.text = options.json ? infoJson(run.report()) : infoText(run.report());
  result.foundError = book.count(Severity::error) > 0;
  return result;
}

} // namespace qmesh
