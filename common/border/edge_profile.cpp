// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "border/edge_profile.h"

#include <algorithm>
#include <cmath>

namespace qmesh {

EdgeProfile edgeProfile(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                        Edge edge) {
  const int cells = tile.cells();
  const int i = edge == kEast ? cells : 0, j = edge == kNorth ? cells : 0;
  const bool alongRow = edge == kSouth || edge == kNorth;
  return {tile.row(j) + i, alongRow ? 1 : tile.row(1) - tile.row(0), frame, alongRow,
          level.latticeStep};
}

bool isPoleEdge(const HeightTile& tile, Edge edge) {
  if (edge == kWest || edge == kEast)
    return false;
  return tile.lattice().isPole(tile.row0() + (edge == kNorth ? tile.cells() : 0));
}

double borderTolerance(const LevelParams& level) {
  // The float32 of a tile's maximum height may move a decoded height by less than this.
  const double margin = std::min(0.0005, level.maxError / 16);
  return std::max(level.maxError - margin, level.borderRounding());
}

WorstOfEdge worstBetween(const EdgeProfile& profile, const EdgeVertex& a, const EdgeVertex& b) {
  const double ha = profile.vertexHeight(a.node);
  const double slope = (profile.vertexHeight(b.node) - ha) / (b.place - a.place);
  WorstOfEdge worst;
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

void splitLine(const EdgeProfile& profile, const EdgeVertex& a, const EdgeVertex& b,
               double tolerance, std::vector<std::uint16_t>& places) {
  const WorstOfEdge worst = worstBetween(profile, a, b);
  if (worst.error > tolerance && b.place - a.place > 1) {
    splitLine(profile, a, worst.vertex, tolerance, places);
    splitLine(profile, worst.vertex, b, tolerance, places);
  } else {
    places.push_back(std::uint16_t(a.place));
  }
}

} // namespace qmesh
