// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "build/estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/stopwatch.h"
#include "build/tile_job.h"
#include "grid/void_fill.h"

namespace qmesh {

namespace {

constexpr std::uint64_t kTilesTried = 8; ///< a zoom
constexpr int kZoomsTried = 3;

/// The n-th tile of a level, in the order of its ranges.
TileId nthTile(const std::vector<TileRange>& ranges, int zoom, std::uint64_t n) {
  for (const TileRange& r : ranges) {
    if (n < r.count()) {
      const std::uint64_t columns = std::uint64_t(r.x1) - r.x0 + 1;
      return {zoom, r.x0 + std::uint32_t(n % columns), r.y0 + std::uint32_t(n / columns)};
    }
    n -= r.count();
  }
  return {zoom, ranges.front().x0, ranges.front().y0};
}

/// The k-th of numbers that spread over 0..count-1 by the golden section: even steps would fall on
/// one column of tiles, the rim of the data perhaps.
std::uint64_t spread(std::uint64_t k, std::uint64_t count) {
  const double place = (double(k) + 0.5) * 0.6180339887498949;
  return std::min(count - 1, std::uint64_t((place - std::floor(place)) * double(count)));
}

/// One tile of a zoom, sampled at that zoom, made and thrown away.
Status tryTile(const TilesetInput& input, NodeSource& nodes, TileId id, TileJob& job,
               std::uint64_t& bytes) {
  NodeWindow window;
  window.reset(input.plan.lattice(id.z), {id.x, id.y, id.x, id.y}, kTileHalo);
  const int first = window.firstExistingRow();
  QMESH_RETURN_IF_ERROR(nodes.sample(window.column0(), window.row0() + first, window.width(),
                                     window.endExistingRow() - first, window.row(first),
                                     window.stride()));
  window.setPoles(input.source.poleHeight(false), input.source.poleHeight(true));
  fillVoids(window, float(input.options.voidValue));
  TileResult result;
  StepSeconds seconds{};
  QMESH_RETURN_IF_ERROR(
      job.run(window.tile(id), input.plan.levels[std::size_t(id.z)], {}, result, seconds));
  bytes += result.bytes.size();
  return {};
}

} // namespace

std::uint64_t Estimate::totalBytes() const {
  return std::accumulate(bytes.begin(), bytes.end(), std::uint64_t(0));
}

Result<Estimate> estimateRun(const TilesetInput& input, const BlockPlan& blocks) {
  const PyramidPlan& plan = input.plan;
  Estimate estimate;
  estimate.bytes.resize(plan.levels.size());
  TileJob job(input.options);
  double bytesPerTile = 0;
  double secondsPerTile = 0;
  for (int zoom = plan.maxZoom; zoom >= plan.minZoom; --zoom) {
    const std::uint64_t count = plan.tiles.count(zoom);
    if (zoom > plan.maxZoom - kZoomsTried) {
      auto nodes = input.source.open(plan.lattice(zoom));
      if (!nodes.ok())
        return nodes.status();
      const auto ranges = plan.tiles.ranges(zoom);
      const std::uint64_t tries = std::min(count, kTilesTried);
      std::uint64_t bytes = 0;
      Stopwatch watch;
      for (std::uint64_t k = 0; k < tries; ++k) {
        const TileId id = nthTile(ranges, zoom, spread(k, count));
        QMESH_RETURN_IF_ERROR(tryTile(input, **nodes, id, job, bytes));
      }
      bytesPerTile = double(bytes) / double(tries);
      secondsPerTile = watch.lap() / double(tries);
    }
    estimate.bytes[std::size_t(zoom)] = std::uint64_t(bytesPerTile * double(count));
    estimate.seconds += secondsPerTile * double(count) / blocks.threads;
  }
  return estimate;
}

} // namespace qmesh
