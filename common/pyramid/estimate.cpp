// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/estimate.h"

#include <numeric>

#include "base/stopwatch.h"
#include "pyramid/sample_tiles.h"
#include "pyramid/tile_job.h"

namespace qmesh {

namespace {

constexpr std::uint64_t kTilesTried = 8; ///< a zoom
constexpr int kZoomsTried = 3;

/// One tile of a zoom, sampled at that zoom, made and thrown away.
Status tryTile(const TilesetInput& input, NodeSource& nodes, TileId id, TileJob& job,
               std::uint64_t& bytes) {
  NodeWindow window;
  QMESH_RETURN_IF_ERROR(sampleTile(input, nodes, id, window));
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
  TileJob job(input.options.method, input.options.output);
  double bytesPerTile = 0;
  double secondsPerTile = 0;
  for (int zoom = plan.maxZoom; zoom >= plan.minZoom; --zoom) {
    const std::uint64_t count = plan.tiles.count(zoom);
    if (zoom > plan.maxZoom - kZoomsTried) {
      auto nodes = input.source.open(plan.lattice(zoom));
      if (!nodes.ok())
        return nodes.status();
      const std::vector<TileId> tries = spreadTiles(plan.tiles, zoom, kTilesTried);
      std::uint64_t bytes = 0;
      Stopwatch watch;
      for (const TileId id : tries)
        QMESH_RETURN_IF_ERROR(tryTile(input, **nodes, id, job, bytes));
      bytesPerTile = double(bytes) / double(tries.size());
      secondsPerTile = watch.lap() / double(tries.size());
    }
    estimate.bytes[std::size_t(zoom)] = std::uint64_t(bytesPerTile * double(count));
    estimate.seconds += secondsPerTile * double(count) / blocks.threads;
  }
  return estimate;
}

} // namespace qmesh
