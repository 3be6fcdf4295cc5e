// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/mesh_thinning.h"

#include "simplify/mesh_list.h"

namespace qmesh {

void MeshThinning::run(const HeightTile& tile, const TileFrame& frame, const BaseGrid& grid,
                       double tolerance, CollapseMesh& mesh) {
  load(tile, frame, mesh);
  decimator_.run(triangulation_, heights_, grid, heights_.scanTolerance(tolerance));
  store(mesh);
}

/// All inner nodes are vertices, and nodes of the border that are none have no say: masked all.
void MeshThinning::load(const HeightTile& tile, const TileFrame& frame, const CollapseMesh& mesh) {
  vertices_.assign(mesh.vertices.begin(), mesh.vertices.end());
  triangulation_.reset(vertices_, mesh.triangles);
  heights_.reset(tile, frame);
  for (int j = 0; j <= frame.cells(); ++j) {
    for (int i = 0; i <= frame.cells(); ++i)
      heights_.mask(i, j);
  }
}

void MeshThinning::store(CollapseMesh& mesh) {
  listMesh(triangulation_, alive_, mesh.triangles);
  std::size_t kept = 0;
  for (const std::int32_t v : alive_)
    mesh.vertices[kept++] = mesh.vertices[std::size_t(v)];
  mesh.vertices.resize(kept);
}

} // namespace qmesh
