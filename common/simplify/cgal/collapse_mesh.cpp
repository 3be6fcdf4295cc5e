// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/collapse_mesh.h"

#include <algorithm>
#include <cmath>

#include "mesh/base_grid.h"
#include "simplify/grid_strips.h"

namespace qmesh {

void VertexRounding::reset(const HeightTile& tile, const TileFrame& frame) {
  tile_ = &tile;
  frame_ = &frame;
}

CollapseVertex VertexRounding::make(int u, int v, std::uint16_t q, Mobility mobility) const {
  CollapseVertex vertex;
  vertex.q = q;
  vertex.mobility = mobility;
  vertex.i = std::uint16_t(frame_->nearestColumn(std::uint16_t(u)));
  vertex.j = std::uint16_t(frame_->nearestRow(std::uint16_t(v)));
  vertex.corner.u = u;
  vertex.corner.v = v;
  vertex.corner.column = spanColumn(u, frame_->cells());
  vertex.corner.height = frame_->decode(q) - frame_->minHeight();
  vertex.corner.row = vertex.j + (frame_->nodeV(vertex.j) < v ? 1 : 0);
  return vertex;
}

CollapseVertex VertexRounding::inner(double u, double v, double height) const {
  const auto whole = [](double place) {
    return int(std::clamp(std::floor(place + 0.5), 1.0, double(kQuantizedMax - 1)));
  };
  const int wholeU = whole(u), wholeV = whole(v);
  const int i = frame_->nearestColumn(std::uint16_t(wholeU));
  const int j = frame_->nearestRow(std::uint16_t(wholeV));
  const int east = wholeU - int(frame_->nodeU(i)), north = wholeV - int(frame_->nodeV(j));
  const bool atNode = (east | north) >> 1 == 0;
  const float kept = atNode ? tile_->at(i, j) : float(height + frame_->minHeight());
  return make(wholeU, wholeV, frame_->quantize(kept), Mobility::inner);
}

CollapseVertex VertexRounding::node(int i, int j, int u, int v, Mobility mobility) const {
  const float height = tile_->at(i, j);
  const int n = frame_->cells();
  const bool onBorder = i == 0 || j == 0 || i == n || j == n;
  return make(u, v, onBorder ? frame_->quantizeBorder(height) : frame_->quantize(height), mobility);
}

namespace {

/// A vertex of a tile edge.
struct EdgePlace {
  int node;
  int place;
  Mobility mobility;

  bool operator<(const EdgePlace& o) const { return place < o.place; }
};

class StartMesh {
 public:
  StartMesh(const HeightTile& tile, const TileFrame& frame, const Border& border,
            const LevelParams& level)
      : tile_(tile), frame_(frame), border_(border), level_(level), n_(tile.cells()) {
    rounding_.reset(tile, frame);
  }

  void make(CollapseMesh& mesh) {
    const BaseGrid curvature(frame_, level_);
    GridWithStrips<CollapseVertex> grid;
    grid.make(
        n_,
        [&](int i, int j) {
          const Mobility mobility = curvature.isNode(i, j) ? Mobility::fixed : Mobility::inner;
          return rounding_.node(i, j, frame_.u(i), frame_.v(j), mobility);
        },
        [&](Edge edge) { return verticesOf(edge); });
    mesh.vertices.swap(grid.vertices);
    mesh.triangles.swap(grid.triangles);
  }

 private:
  bool alongRow(Edge edge) const { return edge == kSouth || edge == kNorth; }
  bool isFar(Edge edge) const { return edge == kEast || edge == kNorth; }
  double exactPlace(Edge edge, int node) const {
    return alongRow(edge) ? frame_.nodeU(node) : frame_.nodeV(node);
  }
  int place(Edge edge, int node) const { return alongRow(edge) ? frame_.u(node) : frame_.v(node); }
  float height(Edge edge, int node) const {
    const int across = isFar(edge) ? n_ : 0;
    return alongRow(edge) ? tile_.at(node, across) : tile_.at(across, node);
  }
  double vertexHeight(Edge edge, int node) const {
    return frame_.decode(frame_.quantizeBorder(height(edge, node)));
  }

  std::vector<CollapseVertex> verticesOf(Edge edge) const;
  CollapseVertex edgeVertex(Edge edge, const EdgePlace& vertex) const;
  std::vector<EdgePlace> placesOf(Edge edge) const;
  std::vector<EdgePlace> freePlaces(Edge edge) const;
  void addPrescribed(const Border& border, Edge edge, std::vector<EdgePlace>& places) const;

  const HeightTile& tile_;
  const TileFrame& frame_;
  const Border& border_;
  const LevelParams& level_;
  VertexRounding rounding_;
  int n_;
};

void StartMesh::addPrescribed(const Border& border, Edge edge,
                              std::vector<EdgePlace>& places) const {
  for (const std::uint16_t given : border[edge]) {
    const int node = alongRow(edge) ? frame_.nearestColumn(given) : frame_.nearestRow(given);
    places.push_back({node, given, Mobility::fixed});
  }
}

std::vector<EdgePlace> StartMesh::placesOf(Edge edge) const {
  std::vector<EdgePlace> places;
  addPrescribed(border_, edge, places);
  if (!border_.isFree[std::size_t(edge)])
    return places;
  if (level_.maxError < level_.borderRounding()) {
    Border contract;
    makeBorder(tile_, frame_, level_, contract);
    addPrescribed(contract, edge, places);
  } else {
    const std::vector<EdgePlace> more = freePlaces(edge);
    places.insert(places.end(), more.begin(), more.end());
  }
  std::stable_sort(places.begin(), places.end());
  const auto same = [](const EdgePlace& a, const EdgePlace& b) { return a.place == b.place; };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  return places;
}

/// All nodes, and those whose rounded place puts them on the slope of a cliff at their other place
/// as well.
std::vector<EdgePlace> StartMesh::freePlaces(Edge edge) const {
  const int kept = n_ / level_.baseGrid;
  std::vector<EdgePlace> places;
  for (int k = 0; k <= n_; ++k) {
    const Mobility mobility = k % kept == 0 ? Mobility::fixed : Mobility::edge;
    places.push_back({k, place(edge, k), mobility});
    const double aside = exactPlace(edge, k) - place(edge, k);
    const int neighbour = aside < 0 ? k - 1 : k + 1;
    if (aside == 0 || neighbour < 0 || neighbour > n_)
      continue;
    const double rise = vertexHeight(edge, neighbour) - vertexHeight(edge, k);
    const double slope = rise / std::abs(place(edge, neighbour) - place(edge, k));
    const double error =
        std::abs(vertexHeight(edge, k) + std::abs(aside) * slope - height(edge, k));
    if (error > level_.maxError)
      places.push_back({k, place(edge, k) + (aside < 0 ? -1 : 1), Mobility::fixed});
  }
  return places;
}

CollapseVertex StartMesh::edgeVertex(Edge edge, const EdgePlace& vertex) const {
  const int across = isFar(edge) ? kQuantizedMax : 0, line = isFar(edge) ? n_ : 0;
  return alongRow(edge) ? rounding_.node(vertex.node, line, vertex.place, across, vertex.mobility)
                        : rounding_.node(line, vertex.node, across, vertex.place, vertex.mobility);
}

std::vector<CollapseVertex> StartMesh::verticesOf(Edge edge) const {
  std::vector<EdgePlace> places = placesOf(edge);
  places.front().mobility = places.back().mobility = Mobility::fixed;
  std::vector<CollapseVertex> vertices;
  for (const EdgePlace& each : places)
    vertices.push_back(edgeVertex(edge, each));
  return vertices;
}

} // namespace

void makeStartMesh(const HeightTile& tile, const TileFrame& frame, const Border& border,
                   const LevelParams& level, CollapseMesh& mesh) {
  StartMesh(tile, frame, border, level).make(mesh);
}

} // namespace qmesh
