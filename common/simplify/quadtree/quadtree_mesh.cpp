// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/quadtree/quadtree_mesh.h"

#include <cmath>

#include "simplify/quadtree/leaf_templates.h"

namespace qmesh {

namespace {

constexpr Edge kEdges[] = {kWest, kSouth, kEast, kNorth};

bool alongRow(Edge edge) {
  return edge == kSouth || edge == kNorth;
}

} // namespace

void QuadtreeMesh::reset(const HeightTile& tile, const TileFrame& frame, const Border& border) {
  tile_ = &tile;
  frame_ = &frame;
  border_ = &border;
  for (const Edge edge : kEdges) {
    auto& has = onBorder_[std::size_t(edge)];
    has.assign(std::size_t(frame.cells()) + 1, 0);
    for (const std::uint16_t place : border[edge]) {
      const int node = alongRow(edge) ? frame.nearestColumn(place) : frame.nearestRow(place);
      if (place == (alongRow(edge) ? frame.u(node) : frame.v(node)))
        has[std::size_t(node)] = 1;
    }
  }
}

bool QuadtreeMesh::hasOtherThanMiddle(Edge edge, int from, int size) const {
  for (int k = from + 1; k < from + size; ++k) {
    if (borderHas(edge, k) && k != from + size / 2)
      return true;
  }
  return false;
}

void QuadtreeMesh::followBorder(RestrictedQuadtree& tree) const {
  const int n = tree.cells();
  for (const Edge edge : kEdges) {
    const int across = edge == kEast || edge == kNorth ? n - 1 : 0;
    for (int k = 0; k < n;) {
      const int i = alongRow(edge) ? k : across, j = alongRow(edge) ? across : k;
      const int size = tree.leafSize(i, j);
      if (hasOtherThanMiddle(edge, k, size))
        tree.divide(i, j);
      else
        k += size;
    }
  }
}

int QuadtreeMesh::middlesOf(const RestrictedQuadtree& tree, const QuadCell& leaf) const {
  if (leaf.size == 1)
    return 0;
  const int n = tree.cells(), half = leaf.size / 2;
  const auto isFiner = [&](int i, int j) { return tree.leafSize(i, j) < leaf.size; };
  const int east = leaf.i + leaf.size, north = leaf.j + leaf.size;
  int middles = 0;
  if (leaf.j > 0 ? isFiner(leaf.i, leaf.j - 1) : borderHas(kSouth, leaf.i + half))
    middles |= kSouthMiddle;
  if (east < n ? isFiner(east, leaf.j) : borderHas(kEast, leaf.j + half))
    middles |= kEastMiddle;
  if (north < n ? isFiner(leaf.i, north) : borderHas(kNorth, leaf.i + half))
    middles |= kNorthMiddle;
  if (leaf.i > 0 ? isFiner(leaf.i - 1, leaf.j) : borderHas(kWest, leaf.j + half))
    middles |= kWestMiddle;
  return middles;
}

/// Of the two ways the free diagonal may run, the one whose middle is nearer to the node there; in
/// the smallest cell the one whose ends differ less.
bool QuadtreeMesh::isRising(const QuadCell& leaf, int middles) const {
  const int i = leaf.i, j = leaf.j, size = leaf.size, half = size / 2;
  const auto height = [&](int di, int dj) { return double(tile_->at(i + di, j + dj)); };
  if (size == 1)
    return std::abs(height(1, 1) - height(0, 0)) <= std::abs(height(0, 1) - height(1, 0));
  const double middle = 2 * height(half, half);
  if (middles == 0)
    return std::abs(height(0, 0) + height(size, size) - middle) <=
           std::abs(height(0, size) + height(size, 0) - middle);
  return std::abs(height(half, 0) + height(half, size) - middle) <=
         std::abs(height(0, half) + height(size, half) - middle);
}

std::int32_t& QuadtreeMesh::indexOf(int i, int j) {
  return index_[std::size_t(j * (frame_->cells() + 1) + i)];
}

std::int32_t& QuadtreeMesh::indexOnEdge(Edge edge, int node) {
  const int across = edge == kEast || edge == kNorth ? frame_->cells() : 0;
  return alongRow(edge) ? indexOf(node, across) : indexOf(across, node);
}

std::uint32_t QuadtreeMesh::vertexAt(int i, int j) {
  std::int32_t& index = indexOf(i, j);
  if (index == Triangulation::kNone) {
    const int n = frame_->cells();
    const bool border = i == 0 || j == 0 || i == n || j == n;
    const float height = tile_->at(i, j);
    index = std::int32_t(tin_.vertices.size());
    tin_.vertices.push_back({frame_->u(i), frame_->v(j),
                             border ? frame_->quantizeBorder(height) : frame_->quantize(height)});
  }
  return std::uint32_t(index);
}

void QuadtreeMesh::addLeaf(const RestrictedQuadtree& tree, const QuadCell& leaf) {
  const int middles = middlesOf(tree, leaf);
  const int half = leaf.size / 2;
  const auto vertexOf = [&](int place) {
    // Counter-clockwise from the south-west corner.
    static constexpr int across[kLeafPlaces] = {0, 1, 2, 2, 2, 1, 0, 0};
    const int di = across[place], dj = across[(place + 6) % kLeafPlaces];
    const auto offset = [&](int halves) { return halves == 1 ? half : halves / 2 * leaf.size; };
    return vertexAt(leaf.i + offset(di), leaf.j + offset(dj));
  };
  for (const LeafTriangle& t : leafTemplate(middles, isRising(leaf, middles)))
    tin_.triangles.push_back({vertexOf(t[0]), vertexOf(t[1]), vertexOf(t[2])});
}

void QuadtreeMesh::build(const RestrictedQuadtree& tree) {
  const auto across = std::size_t(frame_->cells()) + 1;
  index_.assign(across * across, Triangulation::kNone);
  tin_.clear();
  tree.forEachLeaf([&](const QuadCell& leaf) { addLeaf(tree, leaf); });
  nodes_.reset(*tile_, *frame_, tin_);
  fitBorder();
}

/// Takes away the leaves' corners that the border does not have, and adds those of its places that
/// no leaf has: second places of a node.
void QuadtreeMesh::fitBorder() {
  Triangulation& mesh = nodes_.triangulation();
  for (const Edge edge : kEdges) {
    for (int k = 1; k < frame_->cells(); ++k) {
      std::int32_t& index = indexOnEdge(edge, k);
      if (index == Triangulation::kNone || borderHas(edge, k))
        continue;
      mesh.removeBorderVertex(index);
      index = Triangulation::kNone;
    }
  }
  for (const Edge edge : kEdges) {
    for (const std::uint16_t place : (*border_)[edge]) {
      const int node = alongRow(edge) ? frame_->nearestColumn(place) : frame_->nearestRow(place);
      const bool isThere = place == (alongRow(edge) ? frame_->u(node) : frame_->v(node)) &&
                           indexOnEdge(edge, node) != Triangulation::kNone;
      if (!isThere)
        mesh.insert(nodes_.makeBorderVertex(edge, place), mesh.leaving(0) / 3);
    }
  }
  mesh.forgetChanges();
}

} // namespace qmesh
