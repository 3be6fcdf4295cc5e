// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>

#include "pyramid/blocks/chunk_store.h"
#include "pyramid/pyramid_plan.h"

namespace qmesh {

/// Where a stage takes the nodes of its finest level from. Serves one thread.
class FinestNodes {
 public:
  virtual ~FinestNodes() = default;
  /// Fills the nodes of a window of that level; those without a height stay as they are.
  virtual Status load(NodeWindow& window) = 0;
};

/// The first stage: from the input, sampled on the lattice of `zoom`.
Result<std::unique_ptr<FinestNodes>> sampledNodes(const PyramidPlan& plan,
                                                  const NodeSourceFactory& source, int zoom);

/// Later stages: from the raster that the stage before has stored, which must outlive this.
std::unique_ptr<FinestNodes> storedNodes(const ChunkStore& store);

} // namespace qmesh
