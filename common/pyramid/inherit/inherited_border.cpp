// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/inherit/inherited_border.h"

#include <algorithm>

namespace qmesh {

namespace {

constexpr Edge kEdges[] = {kWest, kSouth, kEast, kNorth};

bool runsEastwards(Edge edge) {
  return edge == kSouth || edge == kNorth;
}

bool mayBeChosen(Edge edge, const HeightTile& tile) {
  if (runsEastwards(edge))
    return !tile.lattice().isPole(tile.row0() + (edge == kNorth ? tile.cells() : 0));
  return tile.lattice().columns() > tile.cells();
}

void listBaseGrid(Edge edge, const TileFrame& frame, int baseGrid,
                  std::vector<std::uint16_t>& places) {
  const int n = frame.cells();
  places.clear();
  for (int k = 0; k <= n; k += n / baseGrid)
    places.push_back(runsEastwards(edge) ? frame.u(k) : frame.v(k));
}

} // namespace

void completeBorder(const Simplifier& simplifier, const HeightTile& tile, const TileFrame& frame,
                    const LevelParams& level, Border& border) {
  Border shared;
  simplifier.makeBorder(tile, frame, level, shared);
  for (const Edge edge : kEdges) {
    if (!border.isFree[edge])
      continue;
    border.isFree[edge] = simplifier.choosesBorder() && mayBeChosen(edge, tile);
    if (border.isFree[edge])
      listBaseGrid(edge, frame, level.baseGrid, border[edge]);
    else
      border[edge] = shared[edge];
  }
}

void listBorder(const Tin& tin, Border& border) {
  border.isFree = {};
  for (auto& places : border.places)
    places.clear();
  for (const TinVertex& vertex : tin.vertices) {
    if (vertex.u == 0)
      border[kWest].push_back(vertex.v);
    if (vertex.v == 0)
      border[kSouth].push_back(vertex.u);
    if (vertex.u == kQuantizedMax)
      border[kEast].push_back(vertex.v);
    if (vertex.v == kQuantizedMax)
      border[kNorth].push_back(vertex.u);
  }
  for (auto& places : border.places)
    std::sort(places.begin(), places.end());
}

} // namespace qmesh
