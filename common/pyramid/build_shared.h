// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <mutex>
#include <vector>

#include "pyramid/pyramid_plan.h"
#include "pyramid/report.h"
#include "sink/tile_sink.h"

namespace qmesh {

/// What the threads of a run share. Plans and options are const; the rest guards itself.
struct BuildShared {
  BuildShared(const TilesetInput& input, TileSink& theSink)
      : options(input.options), plan(input.plan), source(input.source), meshes(input.meshes),
        sink(theSink), levels(input.plan.levels.size()) {}

  const BuildOptions& options;
  const PyramidPlan& plan;
  const NodeSourceFactory& source;
  const MeshTaker& meshes;
  TileSink& sink;

  std::mutex mutex; ///< guards what follows
  Availability written;
  std::vector<LevelStats> levels;
  StepSeconds seconds{};
  std::uint64_t contentHash = 0;

  std::atomic<bool> anyData{false}; ///< a node of the finest level has a height
  std::atomic<std::uint64_t> tilesDone{0};
  std::atomic<bool> stop{false};
};

} // namespace qmesh
