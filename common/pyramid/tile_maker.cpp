// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/tile_maker.h"

#include "base/stopwatch.h"

namespace qmesh {

Status TileMaker::make(const HeightTile& tile, const KeptTiles& kept, Border* border,
                       BlockResult& result) {
  const TileId id = tile.id();
  if (kept.contains(id)) {
    const LevelParams& level = context_.plan().levels[std::size_t(id.z)];
    QMESH_RETURN_IF_ERROR(border ? job_.run(tile, level, &kept, *border, tile_, result.seconds)
                                 : job_.run(tile, level, &kept, tile_, result.seconds));
    Stopwatch watch;
    QMESH_RETURN_IF_ERROR(context_.sink.writeTile(id, tile_.bytes));
    if (context_.input.meshes)
      QMESH_RETURN_IF_ERROR(context_.input.meshes(id, job_.exportMesh(tile)));
    result.seconds[int(Step::write)] += watch.lap();
    result.addTile(id.z, tile_.stats, tile_.fingerprint);
  }
  ++context_.control.tilesDone;
  return {};
}

Status TileMaker::makeBlock(BlockWindows& windows, const KeptTiles& kept, BlockResult& result) {
  for (std::size_t k = 0; k < windows.levelCount(); ++k) {
    const BlockWindows::Level level = windows.level(k);
    for (const TileId id : level.tiles) {
      if (context_.control.stop)
        return {};
      QMESH_RETURN_IF_ERROR(make(level.window.tile(id), kept, result));
    }
  }
  return {};
}

} // namespace qmesh
