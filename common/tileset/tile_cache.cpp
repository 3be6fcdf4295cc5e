// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tileset/tile_cache.h"

namespace qmesh {

std::size_t meshBytes(const TileMesh& mesh) {
  std::size_t indices = mesh.indices.size();
  for (const auto& edge : mesh.edges)
    indices += edge.size();
  return sizeof(TileMesh) + 6 * mesh.vertexCount() + 4 * indices + mesh.extensions.normals.size() +
         mesh.extensions.waterMask.size() + mesh.extensions.metadata.size();
}

Result<MeshPtr> TileCache::mesh(TileId tile) {
  if (!set_->mayHave(tile))
    return MeshPtr();
  if (const MeshPtr* known = meshes_.find(tile))
    return *known;
  Result<std::optional<TileMesh>> read = set_->readTile(tile);
  if (!read.ok())
    return read.status();
  MeshPtr mesh;
  if (*read)
    mesh = std::make_shared<const TileMesh>(std::move(**read));
  else if (firstMissing_.empty() && set_->lists(tile))
    firstMissing_ = set_->tilePath(tile);
  meshes_.put(tile, mesh, mesh ? meshBytes(*mesh) : sizeof(TileMesh));
  return mesh;
}

} // namespace qmesh
