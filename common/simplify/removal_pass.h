// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>

#include "mesh/base_grid.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// Offers the inner vertices of a mesh to `tryRemove(vertex)`, which says whether it took the
/// vertex out, in the order of their numbers; those that the grid keeps stay. Returns how many
/// went.
template <class TryRemove>
int removeVertices(const Triangulation& mesh, const BaseGrid& grid, TryRemove tryRemove) {
  int removed = 0;
  for (std::int32_t v = 0; v < std::int32_t(mesh.vertices().size()); ++v) {
    const NodeVertex& vertex = mesh.vertex(v);
    const bool mayGo = isInner(vertex.corner) && !grid.isNode(vertex.i, vertex.j);
    if (mayGo && mesh.leaving(v) != Triangulation::kNone && tryRemove(v))
      ++removed;
  }
  return removed;
}

} // namespace qmesh
