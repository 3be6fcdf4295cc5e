// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/grid_strips.h"

#include <cmath>

namespace qmesh {

void GridWithStrips::addCells() {
  const auto difference = [&](std::int32_t a, std::int32_t b) {
    return std::abs(vertices[std::size_t(a)].corner.height -
                    vertices[std::size_t(b)].corner.height);
  };
  for (int j = 1; j + 1 < cells; ++j) {
    for (int i = 1; i + 1 < cells; ++i) {
      const std::int32_t sw = inner(i, j), se = sw + 1, nw = inner(i, j + 1), ne = nw + 1;
      if (difference(sw, ne) <= difference(se, nw)) {
        addTriangle(sw, se, ne);
        addTriangle(sw, ne, nw);
      } else {
        addTriangle(sw, se, nw);
        addTriangle(se, ne, nw);
      }
    }
  }
}

/// The k-th inner node beside an edge, 1..N-1, counter-clockwise.
std::int32_t GridWithStrips::besideEdge(Edge edge, int k) const {
  switch (edge) {
  case kSouth:
    return inner(k, 1);
  case kEast:
    return inner(cells - 1, k);
  case kNorth:
    return inner(cells - k, cells - 1);
  default:
    return inner(1, cells - k);
  }
}

/// How far along its edge a vertex lies, counter-clockwise.
int GridWithStrips::along(Edge edge, std::int32_t vertex) const {
  const SpanCorner& corner = vertices[std::size_t(vertex)].corner;
  const int place = edge == kSouth || edge == kNorth ? corner.u : corner.v;
  return edge == kNorth || edge == kWest ? kQuantizedMax - place : place;
}

void GridWithStrips::addStrip(Edge edge, const std::vector<NodeVertex>& side) {
  const std::int32_t firstCorner = inner(cells - 1, cells - 1) + 1; // the south-western one
  std::int32_t outer = edge == kSouth ? firstCorner : std::int32_t(vertices.size()) - 1;
  if (edge == kSouth)
    vertices.push_back(side.front());
  int k = 1; // the inner node reached
  std::size_t s = 1;
  const auto nextOuter = [&] {
    const bool closes = edge == kWest && s + 1 == side.size();
    return closes ? firstCorner : std::int32_t(vertices.size());
  };
  while (s < side.size() || k + 1 < cells) {
    bool advanceOuter = k + 1 == cells;
    const std::int32_t here = besideEdge(edge, k);
    if (!advanceOuter && s < side.size()) {
      // The shorter of the two diagonals, by the middles of what they would close.
      const int place = edge == kSouth || edge == kNorth ? side[s].corner.u : side[s].corner.v;
      const int next = edge == kNorth || edge == kWest ? kQuantizedMax - place : place;
      advanceOuter =
          along(edge, outer) + next <= along(edge, here) + along(edge, besideEdge(edge, k + 1));
    }
    if (advanceOuter) {
      const std::int32_t next = nextOuter();
      if (next != firstCorner)
        vertices.push_back(side[s]);
      addTriangle(outer, next, here);
      outer = next;
      ++s;
    } else {
      addTriangle(outer, besideEdge(edge, k + 1), here);
      ++k;
    }
  }
}

} // namespace qmesh
