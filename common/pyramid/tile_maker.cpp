// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/tile_maker.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "codec/metadata.h"

namespace qmesh {

TileMaker::TileMaker(BuildShared& shared)
    : shared_(shared), job_(shared.options), levels_(shared.plan.levels.size()) {}

Status TileMaker::make(const HeightTile& tile, Border* border) {
  const TileId id = tile.id();
  const int every = shared_.options.metadata;
  std::string metadata;
  {
    const std::lock_guard<std::mutex> lock(shared_.mutex);
    const bool written = shared_.written.contains(id);
    if (written && every > 0 && id.z % every == 0) {
      metadata = metadataJson(shared_.written, id, std::min(every, shared_.plan.maxZoom - id.z));
    }
    if (!written) {
      ++shared_.tilesDone;
      return {};
    }
  }
  const LevelParams& level = shared_.plan.levels[std::size_t(id.z)];
  QMESH_RETURN_IF_ERROR(border ? job_.run(tile, level, metadata, *border, result_, seconds_)
                               : job_.run(tile, level, metadata, result_, seconds_));
  Stopwatch watch;
  QMESH_RETURN_IF_ERROR(shared_.sink.writeTile(id, result_.bytes));
  if (shared_.meshes)
    QMESH_RETURN_IF_ERROR(shared_.meshes(id, job_.exportMesh(tile)));
  seconds_[int(Step::write)] += watch.lap();
  levels_[std::size_t(id.z)].add(result_.stats);
  contentHash_ += result_.fingerprint;
  ++shared_.tilesDone;
  return {};
}

void TileMaker::publish() {
  const std::lock_guard<std::mutex> lock(shared_.mutex);
  for (std::size_t z = 0; z < levels_.size(); ++z)
    shared_.levels[z].add(levels_[z]);
  for (std::size_t k = 0; k < seconds_.size(); ++k)
    shared_.seconds[k] += seconds_[k];
  shared_.contentHash += contentHash_;
  std::fill(levels_.begin(), levels_.end(), LevelStats());
  seconds_ = {};
  contentHash_ = 0;
}

} // namespace qmesh
