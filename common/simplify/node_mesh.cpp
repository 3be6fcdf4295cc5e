// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/node_mesh.h"

#include "simplify/grid_strips.h"
#include "simplify/mesh_list.h"

namespace qmesh {

void NodeMesh::reset(const HeightTile& tile, const TileFrame& frame, const Border& border,
                     int baseGrid) {
  tile_ = &tile;
  frame_ = &frame;
  const int n = frame.cells();
  triangulation_.reset({makeVertex(0, 0), makeVertex(n, 0), makeVertex(n, n), makeVertex(0, n)});
  for (const Edge edge : {kWest, kSouth, kEast, kNorth})
    insertEdge(border[edge], edge);
  const int baseCells = n / baseGrid;
  for (int j = baseCells; j < n; j += baseCells) {
    for (int i = baseCells; i < n; i += baseCells)
      insert(i, j);
  }
}

void NodeMesh::reset(const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
  tile_ = &tile;
  frame_ = &frame;
  given_.clear();
  for (const TinVertex& v : tin.vertices) {
    NodeVertex vertex = makeVertex(frame.nearestColumn(v.u), frame.nearestRow(v.v), v.u, v.v);
    vertex.q = v.q;
    vertex.corner.height = frame.decode(v.q) - frame.minHeight();
    given_.push_back(vertex);
  }
  triangulation_.reset(given_, tin.triangles);
}

void NodeMesh::insertEdge(const std::vector<std::uint16_t>& places, Edge edge) {
  for (std::size_t k = 1; k + 1 < places.size(); ++k)
    triangulation_.insert(makeBorderVertex(edge, places[k]), triangulation_.changed().back());
}

void NodeMesh::resetToAllNodes(const HeightTile& tile, const TileFrame& frame,
                               const Border& border) {
  tile_ = &tile;
  frame_ = &frame;
  GridWithStrips<NodeVertex> grid;
  grid.make(
      frame.cells(), [&](int i, int j) { return makeVertex(i, j); },
      [&](Edge edge) {
        std::vector<NodeVertex> side;
        for (const std::uint16_t place : border[edge])
          side.push_back(makeBorderVertex(edge, place));
        return side;
      });
  triangulation_.reset(grid.vertices, grid.triangles);
}

NodeVertex NodeMesh::makeBorderVertex(Edge edge, std::uint16_t place) const {
  const int n = frame_->cells();
  const bool far = edge == kEast || edge == kNorth;
  const int across = far ? kQuantizedMax : 0;
  if (edge == kSouth || edge == kNorth)
    return makeVertex(frame_->nearestColumn(place), far ? n : 0, place, across);
  return makeVertex(far ? n : 0, frame_->nearestRow(place), across, place);
}

NodeVertex NodeMesh::makeVertex(int i, int j, int u, int v) const {
  const int n = frame_->cells();
  const bool border = i == 0 || j == 0 || i == n || j == n;
  const float height = tile_->at(i, j);
  NodeVertex vertex;
  vertex.i = std::uint16_t(i);
  vertex.j = std::uint16_t(j);
  vertex.q = border ? frame_->quantizeBorder(height) : frame_->quantize(height);
  vertex.corner.u = u;
  vertex.corner.v = v;
  vertex.corner.column = spanColumn(u, n);
  vertex.corner.height = frame_->decode(vertex.q) - frame_->minHeight();
  vertex.corner.row = j + (frame_->nodeV(j) < v ? 1 : 0);
  return vertex;
}

NodeVertex NodeMesh::makeVertex(int i, int j) const {
  return makeVertex(i, j, frame_->u(i), frame_->v(j));
}

void NodeMesh::write(Tin& out) {
  out.clear();
  listMesh(triangulation_, alive_, out.triangles);
  for (const std::int32_t v : alive_) {
    const NodeVertex& vertex = triangulation_.vertex(v);
    out.vertices.push_back(
        {std::uint16_t(vertex.corner.u), std::uint16_t(vertex.corner.v), vertex.q});
  }
}

} // namespace qmesh
