// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace qmesh {

namespace {

using Json = nlohmann::ordered_json;

Json statsJson(const LevelStats& stats) {
  return {{"tiles", stats.tiles},
          {"vertices", stats.vertices},
          {"triangles", stats.triangles},
          {"bytes", stats.bytes},
          {"errorReached", stats.maxError},
          {"rmsError", stats.rmsError()},
          {"quantizationTiles", stats.quantizationTiles},
          {"coarseTiles", stats.coarseTiles},
          {"largestCoarseStep", stats.largestCoarseStep}};
}

} // namespace

void LevelStats::add(const LevelStats& other) {
  tiles += other.tiles;
  vertices += other.vertices;
  triangles += other.triangles;
  bytes += other.bytes;
  nodes += other.nodes;
  maxError = std::max(maxError, other.maxError);
  sumSquaredError += other.sumSquaredError;
  quantizationTiles += other.quantizationTiles;
  coarseTiles += other.coarseTiles;
  largestCoarseStep = std::max(largestCoarseStep, other.largestCoarseStep);
}

double LevelStats::rmsError() const {
  return nodes ? std::sqrt(double(sumSquaredError) / 1000 / double(nodes)) : 0;
}

LevelStats BuildReport::total() const {
  LevelStats sum;
  for (const LevelStats& level : levels)
    sum.add(level);
  return sum;
}

std::string reportJson(const BuildReport& report) {
  Json zooms = Json::array();
  for (int z = report.minZoom; z <= report.maxZoom; ++z) {
    Json level = {{"zoom", z}, {"maxError", report.maxErrors[std::size_t(z)]}};
    level.update(statsJson(report.levels[std::size_t(z)]));
    zooms.push_back(level);
  }
  Json seconds = {{"wall", report.wallSeconds}};
  for (int k = 0; k < kStepCount; ++k) {
    seconds[kStepNames[std::size_t(k)]] = report.seconds[std::size_t(k)];
  }
  const Json json = {{"input", report.input},
                     {"output", report.output},
                     {"method", report.method},
                     {"cellsPerTile", report.cellsPerTile},
                     {"threads", report.threads},
                     {"blockTiles", report.blockTiles},
                     {"zooms", zooms},
                     {"total", statsJson(report.total())},
                     {"seconds", seconds}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace qmesh
