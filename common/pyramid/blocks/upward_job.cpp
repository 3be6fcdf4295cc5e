// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/upward_job.h"

#include "grid/void_fill.h"

namespace qmesh {

UpwardJob::UpwardJob(const RunContext& context, const Stage& stage, const Availability& finer,
                     std::unique_ptr<FinestNodes> finest, NodeStores stores, TileMaking making)
    : context_(context), stage_(stage), finer_(finer), stores_(std::move(stores)),
      windows_(context.input, stage, std::move(finest)) {
  if (making == TileMaking::constantFill)
    maker_.emplace(context);
}

Result<BlockResult> UpwardJob::run(TileId block) {
  BlockResult result;
  QMESH_RETURN_IF_ERROR(windows_.load(block, result.seconds));
  result.anyData = windows_.anyData();
  keepTiles(result);
  QMESH_RETURN_IF_ERROR(storeLevels(block));
  if (maker_)
    QMESH_RETURN_IF_ERROR(makeTiles(result));
  return result;
}

/// With -x a tile without data is left out, unless one below it is kept: levels must not have gaps.
void UpwardJob::keepTiles(BlockResult& result) {
  const KeptTiles kept(finer_, result.kept, stage_.finest, context_.plan().maxZoom);
  const bool keepsAll = !context_.options().tiling.excludeVoid;
  for (std::size_t k = 0; k < windows_.levelCount(); ++k) {
    const BlockWindows::Level level = windows_.level(k);
    for (const TileId id : level.tiles)
      if (keepsAll || id.z == 0 || !level.window.isVoid(id) || kept.containsChildOf(id))
        result.kept.add(id);
  }
}

Status UpwardJob::storeLevels(TileId block) {
  for (const NodeWindow& window : windows_.windows())
    if (ChunkStore* store = stores_[std::size_t(window.lattice().zoom())])
      QMESH_RETURN_IF_ERROR(storeNodes(context_.plan(), block, window, *store));
  return {};
}

Status UpwardJob::makeTiles(BlockResult& result) {
  for (std::size_t k = 0; k < windows_.levelCount(); ++k)
    fillVoids(windows_.level(k).window, float(context_.options().heights.voidValue));
  const KeptTiles kept(finer_, result.kept, stage_.finest, context_.plan().maxZoom);
  return maker_->makeBlock(windows_, kept, result);
}

} // namespace qmesh
