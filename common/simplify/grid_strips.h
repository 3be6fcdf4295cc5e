// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "border/border.h"
#include "mesh/tin.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// All inner nodes of a tile as a grid, and around it four strips to whatever vertices the edges
/// have. Fill `vertices` with the inner nodes by rows, then add cells and strips.
struct GridWithStrips {
  explicit GridWithStrips(int cellsPerEdge) : cells(cellsPerEdge) {}

  /// Two triangles for each cell between inner nodes.
  void addCells();

  /// The strip between one edge's vertices, given counter-clockwise from corner to corner, and the
  /// inner nodes beside it. Call for the edges in the order south, east, north, west: a strip
  /// shares its first corner with the strip before.
  void addStrip(Edge edge, const std::vector<NodeVertex>& side);

  int cells;
  std::vector<NodeVertex> vertices;
  std::vector<TinTriangle> triangles;

 private:
  void addTriangle(std::int32_t a, std::int32_t b, std::int32_t c) {
    triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  }
  std::int32_t inner(int i, int j) const { return (j - 1) * (cells - 1) + i - 1; }
  std::int32_t besideEdge(Edge edge, int k) const;
  int along(Edge edge, std::int32_t vertex) const;
};

} // namespace qmesh
