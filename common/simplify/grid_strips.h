// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "border/border.h"
#include "mesh/tin.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// All inner nodes of a tile as a grid, each cell cut along the diagonal whose ends differ less in
/// height, and around it four strips to whatever vertices the edges have. Vertex: a NodeVertex or a
/// class derived from it.
template <class Vertex> class GridWithStrips {
 public:
  /// `nodeAt(i, j)` makes the vertex of an inner node; `sideOf(edge)` the vertices of an edge from
  /// corner to corner, northwards or eastwards. Those of a corner are the same for both edges.
  template <class NodeAt, class SideOf> void make(int cells, NodeAt nodeAt, SideOf sideOf) {
    cells_ = cells;
    vertices.clear();
    triangles.clear();
    for (int j = 1; j < cells; ++j) {
      for (int i = 1; i < cells; ++i)
        vertices.push_back(nodeAt(i, j));
    }
    addCells();
    // Counter-clockwise: a strip shares its first corner with the strip before.
    for (const Edge edge : {kSouth, kEast, kNorth, kWest}) {
      std::vector<Vertex> side = sideOf(edge);
      if (runsBack(edge))
        std::reverse(side.begin(), side.end());
      addStrip(edge, side);
    }
  }

  std::vector<Vertex> vertices; ///< the inner nodes by rows, then the edges'
  std::vector<TinTriangle> triangles;

 private:
  void addTriangle(std::int32_t a, std::int32_t b, std::int32_t c) {
    triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  }
  std::int32_t inner(int i, int j) const { return (j - 1) * (cells_ - 1) + i - 1; }
  static bool runsBack(Edge edge) { return edge == kNorth || edge == kWest; }

  /// How far along its edge a place lies, counter-clockwise.
  static int along(Edge edge, const SpanCorner& corner) {
    const int place = edge == kSouth || edge == kNorth ? corner.u : corner.v;
    return runsBack(edge) ? kQuantizedMax - place : place;
  }
  int along(Edge edge, std::int32_t vertex) const {
    return along(edge, vertices[std::size_t(vertex)].corner);
  }

  void addCells();
  std::int32_t besideEdge(Edge edge, int k) const;
  void addStrip(Edge edge, const std::vector<Vertex>& side);

  int cells_ = 0;
};

template <class Vertex> void GridWithStrips<Vertex>::addCells() {
  const auto difference = [&](std::int32_t a, std::int32_t b) {
    return std::abs(vertices[std::size_t(a)].corner.height -
                    vertices[std::size_t(b)].corner.height);
  };
  for (int j = 1; j + 1 < cells_; ++j) {
    for (int i = 1; i + 1 < cells_; ++i) {
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
template <class Vertex> std::int32_t GridWithStrips<Vertex>::besideEdge(Edge edge, int k) const {
  switch (edge) {
  case kSouth:
    return inner(k, 1);
  case kEast:
    return inner(cells_ - 1, k);
  case kNorth:
    return inner(cells_ - k, cells_ - 1);
  default:
    return inner(1, cells_ - k);
  }
}

/// The strip between one edge's vertices, counter-clockwise, and the inner nodes beside it.
template <class Vertex>
void GridWithStrips<Vertex>::addStrip(Edge edge, const std::vector<Vertex>& side) {
  const std::int32_t firstCorner = inner(cells_ - 1, cells_ - 1) + 1; // the south-western one
  std::int32_t outer = edge == kSouth ? firstCorner : std::int32_t(vertices.size()) - 1;
  if (edge == kSouth)
    vertices.push_back(side.front());
  int k = 1; // the inner node reached
  std::size_t s = 1;
  const auto nextOuter = [&] {
    const bool closes = edge == kWest && s + 1 == side.size();
    return closes ? firstCorner : std::int32_t(vertices.size());
  };
  while (s < side.size() || k + 1 < cells_) {
    bool advanceOuter = k + 1 == cells_;
    const std::int32_t here = besideEdge(edge, k);
    if (!advanceOuter && s < side.size()) {
      // The shorter of the two diagonals, by the middles of what they would close.
      advanceOuter = along(edge, outer) + along(edge, side[s].corner) <=
                     along(edge, here) + along(edge, besideEdge(edge, k + 1));
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
