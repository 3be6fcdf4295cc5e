// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "border/border.h"
#include "grid/height_tile.h"
#include "mesh/level_params.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// Where a vertex may go when an edge of it collapses.
enum class Mobility : std::uint8_t {
  inner, ///< anywhere
  edge,  ///< onto another vertex of its tile edge (free edges of --border inherit)
  fixed, ///< nowhere, and it never vanishes
};

/// A vertex as it will be written, rounded to the tile's frame; i and j name the node nearest to
/// it.
struct CollapseVertex : NodeVertex {
  Mobility mobility = Mobility::inner;
};

/// The mesh the edge collapse begins with.
struct CollapseMesh {
  std::vector<CollapseVertex> vertices;
  std::vector<TinTriangle> triangles; ///< counter-clockwise
};

/// Places of real numbers in the frame of a tile.
class VertexRounding {
 public:
  /// REQUIRES: tile and frame live as long as this is used.
  void reset(const HeightTile& tile, const TileFrame& frame);

  /// An inner vertex nearest to a place (quantized units) and height (metres above the frame's
  /// minimum). At one of the four places around a node it has that node's height, so that a node
  /// can always be cured by vertices at its places (ExactRefinement).
  CollapseVertex inner(double u, double v, double height) const;

  /// The vertex for node (i, j) at a place.
  CollapseVertex node(int i, int j, int u, int v, Mobility mobility) const;

 private:
  CollapseVertex make(int u, int v, std::uint16_t q, Mobility mobility) const;

  const HeightTile* tile_ = nullptr;
  const TileFrame* frame_ = nullptr;
};

/// All inner nodes, joined to the vertices of the border by a strip along each edge: only what the
/// border prescribes lies on it. A free edge has all its nodes, each at the places it takes to be
/// within the max error; where rounding of border heights alone exceeds that, the contract's.
void makeStartMesh(const HeightTile& tile, const TileFrame& frame, const Border& border,
                   const LevelParams& level, CollapseMesh& mesh);

} // namespace qmesh
