// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/mesh_thinning.h"

namespace qmesh {

void MeshThinning::run(const HeightTile& tile, const TileFrame& frame, const CurvatureGrid& grid,
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
  newIndex_.assign(mesh.vertices.size(), 0);
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (triangulation_.leaving(std::int32_t(v)) == Triangulation::kNone)
      continue;
    newIndex_[v] = kept;
    mesh.vertices[kept++] = mesh.vertices[v];
  }
  mesh.vertices.resize(kept);
  mesh.triangles.clear();
  for (std::int32_t t = 0; t < triangulation_.triangleSlots(); ++t) {
    if (!triangulation_.alive(t))
      continue;
    const auto index = [&](int k) {
      return newIndex_[std::size_t(triangulation_.origin(3 * t + k))];
    };
    mesh.triangles.push_back({index(0), index(1), index(2)});
  }
}

} // namespace qmesh
