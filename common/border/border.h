// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/height_tile.h"
#include "mesh/level_params.h"
#include "mesh/tile_frame.h"

namespace qmesh {

/// Order of the four edges everywhere: as in the quantized-mesh format.
enum Edge { kWest = 0, kSouth = 1, kEast = 2, kNorth = 3 };

/// The vertices of a tile's four edges: quantized places 0..32767 along each edge, ascending (from
/// the south-west), both corners included. A vertex stands for the node nearest to it and has its
/// height; where one place is not enough a node has two, on both sides of its real position.
struct Border {
  std::array<std::vector<std::uint16_t>, 4> places;
  /// Edges a method may still add nodes to, at the frame's positions or, as in the contract, at the
  /// places on both sides of the real one (--border inherit, where no neighbour was built before);
  /// all others are final.
  std::array<bool, 4> isFree{};

  std::vector<std::uint16_t>& operator[](Edge edge) { return places[std::size_t(edge)]; }
  const std::vector<std::uint16_t>& operator[](Edge edge) const {
    return places[std::size_t(edge)];
  }
};

/// The border contract (promise P1): the vertices of an edge are a pure function of that edge's
/// nodes and the level, so both its tiles find the same. Top-down insertion of the worst node
/// (Douglas & Peucker 1973) on heights rounded to the level's lattice S and on decoded places,
/// until every node of the edge is within the max error (promise P2): where a vertex's rounded
/// place puts its own node on the slope of a cliff, the node gets the place on its other side as
/// well and so lies on the level between the two. The nodes of the base grid always belong to
/// the edge. A pole's edge has the base grid only.
void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                Border& border);

} // namespace qmesh
