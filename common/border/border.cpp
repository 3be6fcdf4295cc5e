// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "border/border.h"

#include <algorithm>
#include <cmath>

namespace qmesh {

namespace {

/// One edge as a profile: its nodes in ascending order.
struct EdgeProfile {
  const float* heights;
  std::ptrdiff_t stride;
  const TileFrame& frame;
  bool alongRow; ///< south and north edges run along u
  double step;   ///< S of the level, not the coarser one of a tile: the neighbour has another

  double place(int k) const { return alongRow ? frame.nodeU(k) : frame.nodeV(k); }
  double vertexPlace(int k) const { return alongRow ? frame.u(k) : frame.v(k); }
  double height(int k) const { return heights[k * stride]; }
  double vertexHeight(int k) const { return roundToLattice(height(k), step); }
};

/// A node and how far it is from the line between two vertices, metres.
struct Worst {
  int node = -1;
  double error = -1;
};

/// The worst node between the nodes a and b. The two themselves may be off by the rounding of
/// their places; more vertices would not mend that, so they are not asked.
Worst worstBetween(const EdgeProfile& profile, int a, int b) {
  const double pa = profile.vertexPlace(a), ha = profile.vertexHeight(a);
  const double slope = (profile.vertexHeight(b) - ha) / (profile.vertexPlace(b) - pa);
  Worst worst;
  for (int k = a + 1; k < b; ++k) {
    const double error = std::abs(ha + (profile.place(k) - pa) * slope - profile.height(k));
    if (error > worst.error)
      worst = {k, error};
  }
  return worst;
}

/// Appends the vertices within a..b, b excluded, in ascending order.
void splitLine(const EdgeProfile& profile, int a, int b, double tolerance,
               std::vector<std::uint16_t>& vertices) {
  const Worst worst = worstBetween(profile, a, b);
  if (worst.error > tolerance) {
    splitLine(profile, a, worst.node, tolerance, vertices);
    splitLine(profile, worst.node, b, tolerance, vertices);
  } else {
    vertices.push_back(std::uint16_t(a));
  }
}

} // namespace

void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                Border& border) {
  const int cells = tile.cells();
  const int baseCells = cells / level.baseGrid;
  // The float32 of a tile's maximum height may move a decoded height by less than this.
  const double tolerance = level.maxError - std::min(0.0005, level.maxError / 16);
  const std::ptrdiff_t north = tile.row(1) - tile.row(0);
  const auto makeEdge = [&](Edge edge, int i, int j, bool alongRow) {
    const EdgeProfile profile{tile.row(j) + i, alongRow ? 1 : north, frame, alongRow,
                              level.latticeStep};
    const bool pole = alongRow && tile.lattice().isPole(tile.row0() + j);
    std::vector<std::uint16_t>& vertices = border[edge];
    vertices.clear();
    for (int k = 0; k < cells; k += baseCells) {
      if (pole)
        vertices.push_back(std::uint16_t(k));
      else
        splitLine(profile, k, k + baseCells, tolerance, vertices);
    }
    vertices.push_back(std::uint16_t(cells));
  };
  makeEdge(kWest, 0, 0, false);
  makeEdge(kSouth, 0, 0, true);
  makeEdge(kEast, cells, 0, false);
  makeEdge(kNorth, 0, cells, true);
}

} // namespace qmesh
