// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <cstdint>

#include "pyramid/pyramid_plan.h"
#include "sink/tile_sink.h"

namespace qmesh {

/// How a run is stopped and how far it is: the only values its threads write together.
struct RunControl {
  std::atomic<bool> stop{false};           ///< set once; everybody ends soon after
  std::atomic<std::uint64_t> tilesDone{0}; ///< tiles of the plan, those that -x leaves out included
};

/// What the threads of a run have in common. The input is const, the sink takes calls from many
/// threads. What a thread makes is returned as a BlockResult and merged by whoever runs blocks.
struct RunContext {
  const TilesetInput& input;
  TileSink& sink;
  RunControl& control;

  const TilesetOptions& options() const { return input.options; }
  const PyramidPlan& plan() const { return input.plan; }
  const NodeSourceFactory& source() const { return input.source; }
};

} // namespace qmesh
