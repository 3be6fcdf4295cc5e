// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "compare/method_trial.h"

#include <algorithm>
#include <ctime>

#include "base/text.h"
#include "pyramid/tile_job.h"

namespace qmesh {

namespace {

/// Ends of the search where the option's row leaves them open.
constexpr double kLeastValue = 1e-4;
constexpr double kMostValue = 1e7;
constexpr double kPercent = 100;

/// CPU seconds of this thread so far.
double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + double(now.tv_nsec) / 1e9;
}

/// Adds one tile's mesh to the picture of all of them, in whose box its vertices get new places.
void append(const ExportMesh& tile, ExportMesh& all) {
  const auto first = std::uint32_t(all.vertices.size());
  const auto place = [](double value, double low, double high) {
    return (value - low) / (high - low) * kQuantizedMax;
  };
  for (const ExportVertex& vertex : tile.vertices) {
    const double lon = tile.box.west + (tile.box.east - tile.box.west) * (vertex.u / kQuantizedMax);
    const double lat =
        tile.box.south + (tile.box.north - tile.box.south) * (vertex.v / kQuantizedMax);
    all.vertices.push_back({place(lon, all.box.west, all.box.east),
                            place(lat, all.box.south, all.box.north), vertex.height});
  }
  for (const auto& t : tile.triangles)
    all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

} // namespace

MethodTrial::MethodTrial(const std::vector<NodeWindow>& windows, const TilesetInput& input,
                         const SimplifierInfo& info, const std::string& option)
    : windows_(windows), input_(input), info_(info),
      option_(option.empty() ? nullptr : &methodSpec(option)) {}

std::string MethodTrial::Scale::valueText(double x) const {
  return formatNumber(takenFrom > 0 ? takenFrom - x : x);
}

MethodTrial::Scale MethodTrial::scale() const {
  Scale scale;
  scale.low = std::max(kLeastValue, option_->minimum.value_or(0));
  scale.high = std::min(kMostValue, option_->maximum.value_or(kMostValue));
  if (option_->field == &MethodOptions::randomPercent)
    scale.takenFrom = kPercent;
  return scale;
}

/// The options of the run with another method and value; where that is the max error, the level's
/// other parameters follow it.
Result<MethodTrial::Setting> MethodTrial::settingAt(const std::string& value) const {
  const PyramidPlan& plan = input_.plan;
  const int zoom = windows_.front().lattice().zoom();
  Setting setting{input_.options.method, plan.levels[std::size_t(zoom)]};
  setting.options.name = info_.name;
  if (value.empty())
    return setting;
  const auto spec = LevelSpec::parse(value);
  if (!spec.ok())
    return spec.status();
  setting.options.*option_->field = *spec;
  if (option_->field == &MethodOptions::maxError)
    setting.level = levelParams(plan.scheme, zoom, *spec->at(zoom), plan.cells);
  return setting;
}

Result<TrialOutcome> MethodTrial::runTiles(const Setting& setting, ComparedMethod* row) const {
  const auto simplifier = info_.create(setting.options);
  TrialOutcome sum;
  for (const NodeWindow& window : windows_) {
    const HeightTile tile =
        window.tile({window.lattice().zoom(), window.tiles().x0, window.tiles().y0});
    TileFrame frame;
    frame.reset(tile, setting.level);
    Border border;
    Tin tin;
    const double start = cpuSeconds();
    simplifier->makeBorder(tile, frame, setting.level, border);
    QMESH_RETURN_IF_ERROR(simplifier->simplify(tile, frame, border, setting.level, tin));
    if (row) {
      row->cpuSeconds += cpuSeconds() - start;
      row->quality.add(measureQuality(tile, frame, tin));
    }
    sum.triangles += tin.triangles.size();
    sum.maxError = std::max(sum.maxError, tin.maxError);
  }
  return sum;
}

Result<TrialOutcome> MethodTrial::run(const std::string& value) {
  const auto setting = settingAt(value);
  return setting.ok() ? runTiles(*setting, nullptr) : Result<TrialOutcome>(setting.status());
}

Result<ComparedMethod> MethodTrial::measure(const std::string& value) {
  const auto setting = settingAt(value);
  if (!setting.ok())
    return setting.status();
  ComparedMethod row;
  row.method = info_.name;
  row.option = value.empty() ? "" : option_->name;
  row.value = value;
  const auto outcome = runTiles(*setting, &row);
  if (!outcome.ok())
    return outcome.status();
  TileJob job(setting->options, input_.options.output);
  TileResult result;
  StepSeconds seconds{};
  std::vector<ExportMesh> meshes;
  for (const NodeWindow& window : windows_) {
    const HeightTile tile =
        window.tile({window.lattice().zoom(), window.tiles().x0, window.tiles().y0});
    QMESH_RETURN_IF_ERROR(job.run(tile, setting->level, nullptr, result, seconds));
    row.vertices += result.stats.vertices;
    row.triangles += result.stats.triangles;
    row.bytes += result.bytes.size();
    meshes.push_back(job.exportMesh(tile));
  }
  row.mesh.name = info_.name;
  row.mesh.box = meshes.front().box;
  for (const ExportMesh& mesh : meshes) {
    row.mesh.box = {
        std::min(row.mesh.box.west, mesh.box.west), std::min(row.mesh.box.south, mesh.box.south),
        std::max(row.mesh.box.east, mesh.box.east), std::max(row.mesh.box.north, mesh.box.north)};
  }
  for (const ExportMesh& mesh : meshes)
    append(mesh, row.mesh);
  return row;
}

} // namespace qmesh
