// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <map>

#include "mesh/normals.h"
#include "simplified.h"

namespace qmesh::test {

struct SeamVertex {
  double height;
  std::array<std::uint8_t, 2> normal;
};

/// The vertices on one edge by their position along it, as a client decodes them.
inline std::map<int, SeamVertex> seam(const HeightTile& tile, const Simplified& made, Edge edge) {
  const std::vector<std::uint8_t> normals = octNormals(tile, made.frame, made.tin);
  const bool alongRow = edge == kSouth || edge == kNorth;
  const int line = edge == kWest || edge == kSouth ? 0 : kQuantizedMax;
  std::map<int, SeamVertex> vertices;
  for (std::size_t k = 0; k < made.tin.vertices.size(); ++k) {
    const TinVertex& vertex = made.tin.vertices[k];
    if ((alongRow ? vertex.v : vertex.u) == line)
      vertices[alongRow ? vertex.u : vertex.v] = {made.frame.decode(vertex.q),
                                                  {normals[2 * k], normals[2 * k + 1]}};
  }
  return vertices;
}

/// Promise P1 for the two sides of an edge.
inline void expectSeamless(const std::map<int, SeamVertex>& a, const std::map<int, SeamVertex>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (auto x = a.begin(), y = b.begin(); x != a.end(); ++x, ++y) {
    EXPECT_EQ(x->first, y->first);
    EXPECT_NEAR(x->second.height, y->second.height, 0.001);
    EXPECT_EQ(x->second.normal, y->second.normal);
  }
}

} // namespace qmesh::test
