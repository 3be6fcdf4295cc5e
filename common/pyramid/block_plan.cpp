// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/block_plan.h"

#include <algorithm>

#include "grid/node_window.h"
#include "grid/reduce.h"
#include "simplify/simplifier.h"

namespace qmesh {

namespace {

constexpr std::size_t kMiB = 1u << 20;
constexpr int kMaxDepth = 3;                  ///< blocks of 8 x 8 tiles
constexpr std::size_t kBaseBytes = 24 * kMiB; ///< program, libraries, tables
constexpr std::size_t kMinCache = 8 * kMiB;
constexpr std::size_t kMinStore = 4 * kMiB;
constexpr std::size_t kScheduleBytesPerTile = 32;
constexpr std::size_t kBytesPerEdge = 96; ///< of EdgeStore, beside the places of its vertices
constexpr std::uint64_t kBlocksPerThread = 4;

/// Blocks of the stage: ancestors of every tile it meshes.
std::vector<TileId> blocksOf(const PyramidPlan& plan, const Stage& stage) {
  Availability blocks;
  for (int z = stage.finest; z >= stage.coarsest; --z) {
    const int up = z - stage.blockZoom;
    for (const TileRange& r : plan.support.ranges(z)) {
      blocks.add(stage.blockZoom, {r.x0 >> up, r.y0 >> up, r.x1 >> up, r.y1 >> up});
    }
  }
  std::vector<TileId> list;
  for (const TileRange& r : blocks.ranges(stage.blockZoom)) {
    for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
      for (std::uint32_t x = r.x0; x <= r.x1; ++x)
        list.push_back({stage.blockZoom, x, y});
    }
  }
  std::sort(list.begin(), list.end(),
            [](const TileId& a, const TileId& b) { return a.y != b.y ? a.y > b.y : a.x < b.x; });
  return list;
}

/// Bytes one thread takes: the windows of a block's levels, its source, its mesher.
std::size_t bytesPerThread(const TilesetOptions& options, int depth, std::size_t bytesPerSource) {
  std::size_t bytes = bytesPerSource;
  for (int level = 0; level <= depth; ++level) {
    const int tiles = 1 << (depth - level);
    const int halo =
        haloForLevels(options.tiling.overviewResampling, std::max(0, depth - 1 - level));
    bytes += NodeWindow::bytes(tiles, tiles, options.tiling.tileSize, halo);
  }
  const std::size_t edge = std::size_t(options.tiling.tileSize) + 1;
  const bool bridging = options.heights.voidFill == VoidFill::interpolate;
  const std::size_t meshing = bytesPerNode(**chosenSimplifier(options.method), options.method);
  return bytes + edge * edge * (meshing + (bridging ? sizeof(float) : 0));
}

/// The most edges of a level that are built and wait for the tile beyond, under --border inherit: a
/// front of them, and those at the antimeridian, where tiles come in rows or columns; else up to
/// all, two for each tile.
std::size_t waitingEdges(Schedule schedule, const PyramidPlan& plan) {
  std::size_t edges = 0;
  for (const TileRange& r : plan.tiles.ranges(plan.maxZoom)) {
    const std::size_t columns = r.x1 - r.x0 + 1, rows = r.y1 - r.y0 + 1;
    const bool front = schedule == Schedule::rowwise || schedule == Schedule::columnwise;
    edges += 2 * (front ? columns + rows : columns * rows);
  }
  return edges;
}

/// Bytes that do not depend on the threads: under --border inherit also the order of a level's
/// tiles and the edges that wait.
std::size_t commonBytes(const TilingOptions& options, const PyramidPlan& plan) {
  const std::size_t common = kBaseBytes + kMinCache + kMinStore;
  if (options.border != BorderMode::inherit)
    return common;
  const std::size_t edgeBytes =
      kBytesPerEdge + (std::size_t(options.tileSize) + 1) * sizeof(std::uint16_t);
  return common + kScheduleBytesPerTile * std::size_t(plan.tiles.count(plan.maxZoom)) +
         edgeBytes * waitingEdges(options.schedule, plan);
}

int depthOf(int blockTiles) {
  int depth = 0;
  while ((1 << depth) < blockTiles)
    ++depth;
  return depth;
}

/// True when blocks of this depth give every thread several.
bool enoughBlocks(const PyramidPlan& plan, int depth, int threads) {
  const int up = std::min(depth, plan.maxZoom);
  std::uint64_t blocks = 0;
  for (const TileRange& r : plan.tiles.ranges(plan.maxZoom)) {
    blocks += TileRange{r.x0 >> up, r.y0 >> up, r.x1 >> up, r.y1 >> up}.count();
  }
  return threads == 1 || blocks >= kBlocksPerThread * std::uint64_t(threads);
}

} // namespace

int lastZoomNeeded(const HeightOptions& options, const PyramidPlan& plan) {
  return options.voidFill == VoidFill::interpolate ? 0 : plan.minZoom;
}

std::vector<Stage> planStages(const PyramidPlan& plan, int depth, int lastZoom) {
  std::vector<Stage> stages;
  for (int finest = plan.maxZoom;;) {
    Stage stage;
    stage.finest = finest;
    stage.blockZoom = std::max(finest - depth, 0);
    const bool reachesRoot = finest - depth < 0;
    stage.coarsest = std::max(reachesRoot ? 0 : stage.blockZoom + 1, lastZoom);
    stage.feedsNext = !reachesRoot && stage.blockZoom >= lastZoom;
    stage.blocks = blocksOf(plan, stage);
    stages.push_back(std::move(stage));
    if (!stages.back().feedsNext)
      return stages;
    finest = stages.back().blockZoom;
  }
}

Result<BlockPlan> planBlocks(const TilesetOptions& options, const RunOptions& run,
                             const PyramidPlan& plan, std::size_t bytesPerSource, int processors) {
  const auto method = chosenSimplifier(options.method);
  if (!method.ok())
    return method.status();
  const std::size_t memory = std::size_t(run.memoryBytes);
  const int smallest = run.blockTiles ? depthOf(run.blockTiles) : 1;
  const int largest = run.blockTiles ? smallest : kMaxDepth;
  const std::size_t common = commonBytes(options.tiling, plan);
  const std::size_t minimum = common + bytesPerThread(options, smallest, bytesPerSource);
  if (memory < minimum) {
    return Status(Code::usage,
                  "--memory is too small: this run needs at least " +
                      std::to_string((minimum + kMiB - 1) / kMiB) +
                      "MB (less with a smaller --tilesize, or a DEM in smaller blocks: "
                      "gdal_translate -co TILED=YES)");
  }
  for (int threads = run.threads > 0 ? run.threads : processors; threads >= 1; --threads) {
    for (int depth = largest; depth >= smallest; --depth) {
      const std::size_t needed =
          common + std::size_t(threads) * bytesPerThread(options, depth, bytesPerSource);
      if (needed > memory)
        continue;
      if (depth > smallest && !enoughBlocks(plan, depth, threads))
        continue;
      BlockPlan blocks;
      blocks.blockTiles = 1 << depth;
      blocks.threads = threads;
      const std::size_t spare = memory - needed;
      blocks.cacheBytes = kMinCache + spare / 4;
      blocks.storeBytes = kMinStore + spare / 2;
      blocks.stages = planStages(plan, depth, lastZoomNeeded(options.heights, plan));
      return blocks;
    }
  }
  return Status(Code::internal, "no block size fits into --memory");
}

} // namespace qmesh
