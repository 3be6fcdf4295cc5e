// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/finest_nodes.h"

#include <algorithm>

namespace qmesh {

namespace {

/// Nodes are taken from the closed squares of planned tiles only: what lies beyond (rims of the
/// extent's estimate, tiles the user left out) is void for every block alike.
class SampledNodes : public FinestNodes {
 public:
  SampledNodes(const PyramidPlan& plan, std::unique_ptr<NodeSource> source)
      : plan_(plan), source_(std::move(source)) {}

  Status load(NodeWindow& window) override {
    const std::int64_t columns = window.lattice().columns();
    for (const TileRange& range : plan_.dataTiles)
      for (const std::int64_t shift : {-columns, std::int64_t(0), columns})
        QMESH_RETURN_IF_ERROR(sample(window, range, shift));
    return {};
  }

 private:
  Status sample(NodeWindow& window, const TileRange& range, std::int64_t columnShift) {
    const std::int64_t n = window.lattice().cells();
    const std::int64_t i0 = std::max(range.x0 * n + columnShift, window.column0());
    const std::int64_t i1 =
        std::min((range.x1 + 1) * n + columnShift, window.column0() + window.width() - 1);
    const std::int64_t j0 = std::max(range.y0 * n, window.row0());
    const std::int64_t j1 = std::min((range.y1 + 1) * n, window.row0() + window.height() - 1);
    if (i0 > i1 || j0 > j1)
      return {};
    return source_->sample(i0, j0, int(i1 - i0 + 1), int(j1 - j0 + 1),
                           window.row(int(j0 - window.row0())) + (i0 - window.column0()),
                           window.stride());
  }

  const PyramidPlan& plan_;
  std::unique_ptr<NodeSource> source_;
};

class StoredNodes : public FinestNodes {
 public:
  explicit StoredNodes(const ChunkStore& store) : store_(store) {}
  Status load(NodeWindow& window) override { return store_.read(window); }

 private:
  const ChunkStore& store_;
};

} // namespace

Result<std::unique_ptr<FinestNodes>> sampledNodes(const PyramidPlan& plan,
                                                  const NodeSourceFactory& source, int zoom) {
  auto opened = source.open(plan.lattice(zoom));
  if (!opened.ok())
    return opened.status();
  return std::unique_ptr<FinestNodes>(std::make_unique<SampledNodes>(plan, *std::move(opened)));
}

std::unique_ptr<FinestNodes> storedNodes(const ChunkStore& store) {
  return std::make_unique<StoredNodes>(store);
}

} // namespace qmesh
