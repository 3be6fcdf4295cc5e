// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/collapse_mesh.h"

#include <algorithm>
#include <cmath>

namespace qmesh {

void VertexRounding::reset(const HeightTile& tile, const TileFrame& frame) {
  tile_ = &tile;
  frame_ = &frame;
}

CollapseVertex VertexRounding::make(int u, int v, std::uint16_t q, Mobility mobility) const {
  CollapseVertex vertex;
  vertex.q = q;
  vertex.mobility = mobility;
  vertex.corner.u = u;
  vertex.corner.v = v;
  vertex.corner.column = spanColumn(u, frame_->cells());
  vertex.corner.height = frame_->decode(q) - frame_->minHeight();
  const int row = frame_->nearestRow(std::uint16_t(v));
  vertex.corner.row = row + (frame_->nodeV(row) < v ? 1 : 0);
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
            const LevelParams& level, CollapseMesh& mesh)
      : tile_(tile), frame_(frame), border_(border), level_(level), mesh_(mesh), n_(tile.cells()) {
    rounding_.reset(tile, frame);
  }

  void make() {
    mesh_.vertices.clear();
    mesh_.triangles.clear();
    addInnerNodes();
    corners_ = std::uint32_t(mesh_.vertices.size());
    for (int k = 0; k < 4; ++k)
      addNode(k & 1 ? n_ : 0, k & 2 ? n_ : 0, Mobility::fixed);
    for (const Edge edge : {kWest, kSouth, kEast, kNorth})
      addStrip(edge);
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
  std::uint32_t inner(int i, int j) const { return std::uint32_t((j - 1) * (n_ - 1) + i - 1); }
  std::uint32_t corner(Edge edge, bool end) const {
    const std::uint32_t first = edge == kEast ? 1 : edge == kNorth ? 2 : 0;
    return corners_ + first + (end ? (alongRow(edge) ? 1 : 2) : 0);
  }

  void addNode(int i, int j, Mobility mobility) {
    mesh_.vertices.push_back(rounding_.node(i, j, frame_.u(i), frame_.v(j), mobility));
  }

  void addInnerNodes();
  void addEdgeVertex(Edge edge, const EdgePlace& vertex);
  void addStrip(Edge edge);
  void addTriangle(Edge edge, std::uint32_t a, std::uint32_t b, std::uint32_t c);
  std::vector<EdgePlace> placesOf(Edge edge) const;
  std::vector<EdgePlace> freePlaces(Edge edge) const;
  void addPrescribed(const Border& border, Edge edge, std::vector<EdgePlace>& places) const;

  const HeightTile& tile_;
  const TileFrame& frame_;
  const Border& border_;
  const LevelParams& level_;
  CollapseMesh& mesh_;
  VertexRounding rounding_;
  int n_;
  std::uint32_t corners_ = 0; ///< south-west, south-east, north-west, north-east
};

void StartMesh::addInnerNodes() {
  const int kept = n_ / level_.baseGrid;
  for (int j = 1; j < n_; ++j) {
    for (int i = 1; i < n_; ++i)
      addNode(i, j, i % kept == 0 && j % kept == 0 ? Mobility::fixed : Mobility::inner);
  }
  for (int j = 1; j + 1 < n_; ++j) {
    for (int i = 1; i + 1 < n_; ++i) {
      const std::uint32_t sw = inner(i, j), se = inner(i + 1, j);
      const std::uint32_t nw = inner(i, j + 1), ne = inner(i + 1, j + 1);
      const float rising = std::abs(tile_.at(i + 1, j + 1) - tile_.at(i, j));
      const float falling = std::abs(tile_.at(i, j + 1) - tile_.at(i + 1, j));
      if (rising <= falling) {
        mesh_.triangles.push_back({sw, se, ne});
        mesh_.triangles.push_back({sw, ne, nw});
      } else {
        mesh_.triangles.push_back({sw, se, nw});
        mesh_.triangles.push_back({se, ne, nw});
      }
    }
  }
}

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

void StartMesh::addEdgeVertex(Edge edge, const EdgePlace& vertex) {
  const int across = isFar(edge) ? kQuantizedMax : 0, line = isFar(edge) ? n_ : 0;
  mesh_.vertices.push_back(
      alongRow(edge) ? rounding_.node(vertex.node, line, vertex.place, across, vertex.mobility)
                     : rounding_.node(line, vertex.node, across, vertex.place, vertex.mobility));
}

/// A triangle given in the order that is counter-clockwise at the south edge.
void StartMesh::addTriangle(Edge edge, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const bool turned = edge == kNorth || edge == kWest;
  mesh_.triangles.push_back(turned ? TinTriangle{a, c, b} : TinTriangle{a, b, c});
}

/// Triangles between the vertices of an edge and the first line of inner nodes, each step on the
/// side whose next piece has its middle first.
void StartMesh::addStrip(Edge edge) {
  std::vector<std::uint32_t> outer, line;
  const std::vector<EdgePlace> places = placesOf(edge);
  outer.push_back(corner(edge, false));
  for (std::size_t k = 1; k + 1 < places.size(); ++k) {
    outer.push_back(std::uint32_t(mesh_.vertices.size()));
    addEdgeVertex(edge, places[k]);
  }
  outer.push_back(corner(edge, true));
  const int across = isFar(edge) ? n_ - 1 : 1;
  for (int k = 1; k < n_; ++k)
    line.push_back(alongRow(edge) ? inner(k, across) : inner(across, k));

  const auto at = [&](std::uint32_t vertex) {
    const SpanCorner& c = mesh_.vertices[vertex].corner;
    return alongRow(edge) ? c.u : c.v;
  };
  std::size_t a = 0, b = 0;
  while (a + 1 < outer.size() || b + 1 < line.size()) {
    const bool stepOuter =
        b + 1 == line.size() ||
        (a + 1 < outer.size() && at(outer[a]) + at(outer[a + 1]) <= at(line[b]) + at(line[b + 1]));
    if (stepOuter) {
      addTriangle(edge, outer[a], outer[a + 1], line[b]);
      ++a;
    } else {
      addTriangle(edge, outer[a], line[b + 1], line[b]);
      ++b;
    }
  }
}

} // namespace

void makeStartMesh(const HeightTile& tile, const TileFrame& frame, const Border& border,
                   const LevelParams& level, CollapseMesh& mesh) {
  StartMesh(tile, frame, border, level, mesh).make();
}

} // namespace qmesh
