// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "border/border.h"

#include "border/edge_profile.h"

namespace qmesh {

void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                Border& border) {
  const int cells = tile.cells();
  const int baseCells = cells / level.baseGrid;
  const double tolerance = borderTolerance(level);
  for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
    const EdgeProfile profile = edgeProfile(tile, frame, level, edge);
    std::vector<std::uint16_t>& places = border[edge];
    places.clear();
    for (int k = 0; k < cells; k += baseCells) {
      const EdgeVertex from{k, profile.nearestPlace(k)};
      const EdgeVertex to{k + baseCells, profile.nearestPlace(k + baseCells)};
      if (isPoleEdge(tile, edge))
        places.push_back(std::uint16_t(from.place));
      else
        splitLine(profile, from, to, tolerance, places);
    }
    places.push_back(kQuantizedMax);
  }
}

} // namespace qmesh
