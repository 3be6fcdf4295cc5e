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

  double place(int node) const { return alongRow ? frame.nodeU(node) : frame.nodeV(node); }
  int nearestPlace(int node) const { return alongRow ? frame.u(node) : frame.v(node); }
  double height(int node) const { return heights[node * stride]; }
  double vertexHeight(int node) const { return roundToLattice(height(node), step); }
};

/// A vertex of an edge: a node at one of the two places around its position.
struct EdgeVertex {
  int node;
  int place;
};

struct Worst {
  EdgeVertex vertex{-1, 0}; ///< what to insert
  double error = -1;        ///< metres
};

/// The node whose position lies between two vertices and that is farthest from the line between
/// them. That may be the node of one of the two: then its other place goes in.
Worst worstBetween(const EdgeProfile& profile, const EdgeVertex& a, const EdgeVertex& b) {
  const double ha = profile.vertexHeight(a.node);
  const double slope = (profile.vertexHeight(b.node) - ha) / (b.place - a.place);
  Worst worst;
  for (int k = a.node; k <= b.node; ++k) {
    const double place = profile.place(k);
    if (place <= a.place || place >= b.place)
      continue;
    const double error = std::abs(ha + (place - a.place) * slope - profile.height(k));
    if (error > worst.error) {
      worst.error = error;
      worst.vertex = {k, k == a.node   ? a.place + 1
                         : k == b.node ? b.place - 1
                                       : profile.nearestPlace(k)};
    }
  }
  return worst;
}

/// Appends the places within a..b, b excluded, in ascending order.
void splitLine(const EdgeProfile& profile, const EdgeVertex& a, const EdgeVertex& b,
               double tolerance, std::vector<std::uint16_t>& places) {
  const Worst worst = worstBetween(profile, a, b);
  if (worst.error > tolerance && b.place - a.place > 1) {
    splitLine(profile, a, worst.vertex, tolerance, places);
    splitLine(profile, worst.vertex, b, tolerance, places);
  } else {
    places.push_back(std::uint16_t(a.place));
  }
}

} // namespace

void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                Border& border) {
  const int cells = tile.cells();
  const int baseCells = cells / level.baseGrid;
  // The float32 of a tile's maximum height may move a decoded height by less than this.
  const double tolerance =
      std::max(level.maxError - std::min(0.0005, level.maxError / 16), level.borderRounding());
  const std::ptrdiff_t north = tile.row(1) - tile.row(0);
  const auto makeEdge = [&](Edge edge, int i, int j, bool alongRow) {
    const EdgeProfile profile{tile.row(j) + i, alongRow ? 1 : north, frame, alongRow,
                              level.latticeStep};
    const bool pole = alongRow && tile.lattice().isPole(tile.row0() + j);
    std::vector<std::uint16_t>& places = border[edge];
    places.clear();
    for (int k = 0; k < cells; k += baseCells) {
      const EdgeVertex from{k, profile.nearestPlace(k)};
      const EdgeVertex to{k + baseCells, profile.nearestPlace(k + baseCells)};
      if (pole)
        places.push_back(std::uint16_t(from.place));
      else
        splitLine(profile, from, to, tolerance, places);
    }
    places.push_back(kQuantizedMax);
  };
  makeEdge(kWest, 0, 0, false);
  makeEdge(kSouth, 0, 0, true);
  makeEdge(kEast, cells, 0, false);
  makeEdge(kNorth, 0, cells, true);
}

} // namespace qmesh
