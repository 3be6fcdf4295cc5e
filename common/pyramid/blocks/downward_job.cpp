// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/downward_job.h"

#include "grid/void_fill.h"

namespace qmesh {

DownwardJob::DownwardJob(const RunContext& context, const Stage& stage, const KeptTiles& kept,
                         std::unique_ptr<FinestNodes> finest, const Stores& stores)
    : context_(context), kept_(kept), stores_(stores),
      windows_(context.input, stage, std::move(finest)), maker_(context) {}

Result<BlockResult> DownwardJob::run(TileId block) {
  BlockResult result;
  QMESH_RETURN_IF_ERROR(windows_.load(block, result.seconds));
  QMESH_RETURN_IF_ERROR(fillAll(block));
  if (stores_.finest)
    QMESH_RETURN_IF_ERROR(
        storeNodes(context_.plan(), block, windows_.windows().front(), *stores_.finest));
  QMESH_RETURN_IF_ERROR(maker_.makeBlock(windows_, kept_, result));
  return result;
}

Status DownwardJob::fillAll(TileId block) {
  const PyramidPlan& plan = context_.plan();
  const float value = float(context_.options().heights.voidValue);
  if (stores_.above) {
    above_.reset(plan.lattice(block.z), {block.x, block.y, block.x, block.y}, kTileHalo);
    QMESH_RETURN_IF_ERROR(stores_.above->read(above_));
    fillVoids(above_, value);
  }
  for (std::size_t k = windows_.levelCount(); k-- > 0;) {
    NodeWindow& window = windows_.level(k).window;
    fillVoidsOutside(window, plan.support, value);
    if (k + 1 < windows_.levelCount())
      fillVoids(window, windows_.level(k + 1).window);
    else if (stores_.above)
      fillVoids(window, above_);
    else
      fillVoids(window, value);
  }
  return {};
}

} // namespace qmesh
