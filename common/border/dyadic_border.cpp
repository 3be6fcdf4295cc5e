// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "border/dyadic_border.h"

#include "border/edge_profile.h"

namespace qmesh {

namespace {

/// One edge on its way.
struct Halving {
  const EdgeProfile& profile;
  const StretchRule& cuts;
  double tolerance;
  std::vector<std::uint16_t>& places;
};

/// Appends the places from..to, `to` excluded.
void halve(const Halving& edge, EdgeStretch stretch) {
  const auto vertex = [&](int node) { return EdgeVertex{node, edge.profile.nearestPlace(node)}; };
  const EdgeVertex from = vertex(stretch.from), to = vertex(stretch.to);
  stretch.error = worstBetween(edge.profile, from, to).error;
  if (!edge.cuts(stretch)) {
    edge.places.push_back(std::uint16_t(from.place));
  } else if (stretch.to - stretch.from == 1) {
    splitLine(edge.profile, from, to, edge.tolerance, edge.places);
  } else {
    const int middle = (stretch.from + stretch.to) / 2;
    halve(edge, {stretch.edge, stretch.from, middle, 0});
    halve(edge, {stretch.edge, middle, stretch.to, 0});
  }
}

} // namespace

void makeDyadicBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                      const StretchRule& cuts, Border& border) {
  const int cells = tile.cells();
  const int baseCells = cells / level.baseGrid;
  const StretchRule never = [](const EdgeStretch&) { return false; };
  for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
    const EdgeProfile profile = edgeProfile(tile, frame, level, edge);
    border[edge].clear();
    const Halving halving{profile, isPoleEdge(tile, edge) ? never : cuts, borderTolerance(level),
                          border[edge]};
    for (int k = 0; k < cells; k += baseCells)
      halve(halving, {edge, k, k + baseCells, 0});
    border[edge].push_back(kQuantizedMax);
  }
}

} // namespace qmesh
