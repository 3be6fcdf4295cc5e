// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/mesh_list.h"

namespace qmesh {

void listMesh(const Triangulation& mesh, std::vector<std::int32_t>& vertices,
              std::vector<TinTriangle>& triangles) {
  vertices.clear();
  triangles.clear();
  std::vector<std::uint32_t> placeOf(mesh.vertices().size());
  for (std::int32_t v = 0; v < std::int32_t(placeOf.size()); ++v) {
    if (mesh.leaving(v) == Triangulation::kNone)
      continue;
    placeOf[std::size_t(v)] = std::uint32_t(vertices.size());
    vertices.push_back(v);
  }
  for (std::int32_t t = 0; t < mesh.triangleSlots(); ++t) {
    if (!mesh.alive(t))
      continue;
    const auto place = [&](int k) { return placeOf[std::size_t(mesh.origin(3 * t + k))]; };
    triangles.push_back({place(0), place(1), place(2)});
  }
}

} // namespace qmesh
