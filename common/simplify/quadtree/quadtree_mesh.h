// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "border/border.h"
#include "mesh/tin.h"
#include "simplify/node_mesh.h"
#include "simplify/quadtree/restricted_quadtree.h"

namespace qmesh {

/// The triangles of a restricted quadtree within a prescribed border: every leaf by its template,
/// and along the border only the vertices it has.
class QuadtreeMesh {
 public:
  /// REQUIRES: the arguments live as long as the mesh is used.
  void reset(const HeightTile& tile, const TileFrame& frame, const Border& border);

  /// Divides the leaves along the border until each has no more than the middle of its side there.
  void followBorder(RestrictedQuadtree& tree) const;

  /// REQUIRES: followBorder() was called for the tree or for one it was divided from.
  void build(const RestrictedQuadtree& tree);

  NodeMesh& nodes() { return nodes_; }
  const NodeMesh& nodes() const { return nodes_; }

 private:
  bool borderHas(Edge edge, int node) const {
    return onBorder_[std::size_t(edge)][std::size_t(node)] != 0;
  }
  bool hasOtherThanMiddle(Edge edge, int from, int size) const;
  int middlesOf(const RestrictedQuadtree& tree, const QuadCell& leaf) const;
  bool isRising(const QuadCell& leaf, int middles) const;
  void addLeaf(const RestrictedQuadtree& tree, const QuadCell& leaf);
  std::int32_t& indexOf(int i, int j);
  std::int32_t& indexOnEdge(Edge edge, int node);
  std::uint32_t vertexAt(int i, int j);
  void fitBorder();

  const HeightTile* tile_ = nullptr;
  const TileFrame* frame_ = nullptr;
  const Border* border_ = nullptr;
  std::array<std::vector<std::uint8_t>, 4> onBorder_; ///< by node: the border has its place
  std::vector<std::int32_t> index_;                   ///< by node: of its vertex, or kNone
  Tin tin_;
  NodeMesh nodes_;
};

} // namespace qmesh
