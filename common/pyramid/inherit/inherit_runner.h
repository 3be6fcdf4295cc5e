// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>
#include <vector>

#include "pyramid/blocks/stage_runner.h"
#include "pyramid/inherit/edge_store.h"
#include "pyramid/inherit/tile_queue.h"

namespace qmesh {

/// --border inherit: an upward pass makes the nodes of every level; then, level by level from the
/// coarsest, threads mesh tile after tile in an order that gives what the schedule's order one by
/// one gives.
class InheritRunner {
 public:
  InheritRunner(const RunContext& context, const BlockPlan& blocks, WorkTeam& team,
                StageRunner& stages)
      : context_(context), blocks_(blocks), team_(team), stages_(stages) {}

  Status run();

 private:
  class Worker;
  struct Level;

  Status runLevel(int zoom);
  Status fillOthers(Level& level, int zoom);
  Status runTeam(std::size_t tiles, const std::function<Status()>& work);
  Status work(Level& level);

  const RunContext& context_;
  const BlockPlan& blocks_;
  WorkTeam& team_;
  StageRunner& stages_;
  Availability kept_;                          ///< every tile that will be written
  std::uint64_t total_ = 0;                    ///< their number
  std::vector<StageRunner::StorePointer> raw_; ///< by zoom
  StageRunner::StorePointer coarser_, filled_; ///< without voids (VoidFill::interpolate)
};

} // namespace qmesh
