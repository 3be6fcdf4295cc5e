// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "border/border.h"
#include "grid/height_tile.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// The Delaunay triangulation of nodes of one tile, as it will be decoded: vertices lie at rounded
/// places and heights. Memory is kept from tile to tile.
class NodeMesh {
 public:
  /// Begins with the corners, the border's vertices and the inner nodes of the base grid.
  /// REQUIRES: the tile and the frame live as long as the mesh is used.
  void reset(const HeightTile& tile, const TileFrame& frame, const Border& border, int baseGrid);

  /// Begins with a TIN of any vertices; each counts as one of the node nearest to it.
  /// REQUIRES: as above, and checkTin() passes.
  void reset(const HeightTile& tile, const TileFrame& frame, const Tin& tin);
  /// Begins with all inner nodes within the border's vertices: cells cut along the diagonal whose
  /// ends differ less in height, and a strip along each edge. Not Delaunay.
  void resetToAllNodes(const HeightTile& tile, const TileFrame& frame, const Border& border);

  /// The vertex for node (i, j) at the frame's place or at another one.
  NodeVertex makeVertex(int i, int j) const;
  NodeVertex makeVertex(int i, int j, int u, int v) const;
  /// The vertex at a place of the border.
  NodeVertex makeBorderVertex(Edge edge, std::uint16_t place) const;

  /// Makes an inner node a vertex; the search begins near the last change, or at the triangle
  /// `hint`. REQUIRES: it is none yet.
  void insert(int i, int j) { insert(i, j, triangulation_.changed().back()); }
  void insert(int i, int j, std::int32_t hint) { triangulation_.insert(makeVertex(i, j), hint); }

  Triangulation& triangulation() { return triangulation_; }
  const Triangulation& triangulation() const { return triangulation_; }

  /// Overwrites `out` with vertices and triangles; no measures.
  void write(Tin& out);

 private:
  void insertEdge(const std::vector<std::uint16_t>& places, Edge edge);

  const HeightTile* tile_ = nullptr;
  const TileFrame* frame_ = nullptr;
  Triangulation triangulation_;
  std::vector<std::int32_t> alive_;
  std::vector<NodeVertex> given_;
};

} // namespace qmesh
