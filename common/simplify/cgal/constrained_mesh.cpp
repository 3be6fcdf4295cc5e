// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/constrained_mesh.h"

#include <algorithm>
#include <numeric>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace qmesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr std::uint32_t kNone = ~0u;

/// The bits of a coordinate at every other place.
std::uint32_t spreadBits(std::uint32_t x) {
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

/// The place on a Z-order curve (Morton 1966): neighbours in it are mostly near one another, and
/// no two vertices share one.
std::uint32_t curvePlace(const TinVertex& vertex) {
  return spreadBits(vertex.u) | spreadBits(vertex.v) << 1;
}

/// Collects the vertices of a mesh, each once.
class VertexList {
 public:
  VertexList(const HeightTile& tile, const TileFrame& frame, Tin& out)
      : tile_(tile), frame_(frame), grid_(frame.cells()), out_(out), ofNode_(grid_.size(), kNone) {}

  /// The vertex of a node at the frame's place.
  std::uint32_t ofNode(NodeIndex node) {
    std::uint32_t& vertex = ofNode_[std::size_t(node)];
    if (vertex == kNone)
      vertex = add(node, frame_.u(grid_.column(node)), frame_.v(grid_.row(node)));
    return vertex;
  }

  void addBorder(const Border& border) {
    const int n = frame_.cells();
    for (const int corner :
         {grid_.index(0, 0), grid_.index(n, 0), grid_.index(n, n), grid_.index(0, n)})
      ofNode(corner);
    for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
      for (const std::uint16_t place : border[edge])
        addPlace(edge, place);
    }
  }

 private:
  /// A border vertex, which may lie beside its node.
  void addPlace(Edge edge, std::uint16_t place) {
    const int n = frame_.cells();
    if (place == 0 || place == kQuantizedMax)
      return;
    const bool far = edge == kEast || edge == kNorth;
    const std::uint16_t across = far ? kQuantizedMax : 0;
    const int end = far ? n : 0;
    const bool alongRow = edge == kSouth || edge == kNorth;
    const int i = alongRow ? frame_.nearestColumn(place) : end;
    const int j = alongRow ? end : frame_.nearestRow(place);
    const std::uint16_t u = alongRow ? place : across, v = alongRow ? across : place;
    if (u == frame_.u(i) && v == frame_.v(j))
      ofNode(grid_.index(i, j));
    else
      add(grid_.index(i, j), u, v);
  }

  std::uint32_t add(NodeIndex node, std::uint16_t u, std::uint16_t v) {
    const float height = tile_.at(grid_.column(node), grid_.row(node));
    out_.vertices.push_back(
        {u, v, grid_.isInner(node) ? frame_.quantize(height) : frame_.quantizeBorder(height)});
    return std::uint32_t(out_.vertices.size() - 1);
  }

  const HeightTile& tile_;
  const TileFrame& frame_;
  NodeGrid grid_;
  Tin& out_;
  std::vector<std::uint32_t> ofNode_;
};

/// Inserts the vertices; returns their handles by number.
std::vector<Delaunay::Vertex_handle> insertVertices(const Tin& tin, Delaunay& mesh) {
  std::vector<std::uint32_t> order(tin.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return curvePlace(tin.vertices[a]) < curvePlace(tin.vertices[b]);
  });
  std::vector<Delaunay::Vertex_handle> handles(tin.vertices.size());
  Delaunay::Face_handle near;
  for (const std::uint32_t k : order) {
    const TinVertex& vertex = tin.vertices[k];
    handles[k] = mesh.insert(Kernel::Point_2(vertex.u, vertex.v), near);
    handles[k]->info() = k;
    near = handles[k]->face();
  }
  return handles;
}

void writeTriangles(const Delaunay& mesh, Tin& out) {
  for (auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face)
    out.triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
}

} // namespace

bool makeConstrainedMesh(const HeightTile& tile, const TileFrame& frame, const Border& border,
                         const MeshParts& parts, Tin& out) {
  out.clear();
  VertexList vertices(tile, frame, out);
  vertices.addBorder(border);
  for (const NodeIndex node : parts.nodes)
    vertices.ofNode(node);
  for (const NodeLine& line : parts.lines) {
    for (const NodeIndex node : line)
      vertices.ofNode(node);
  }
  Delaunay mesh;
  const auto handles = insertVertices(out, mesh);
  try {
    for (const NodeLine& line : parts.lines) {
      for (std::size_t k = 1; k < line.size(); ++k)
        mesh.insert_constraint(handles[vertices.ofNode(line[k - 1])],
                               handles[vertices.ofNode(line[k])]);
    }
  } catch (const Delaunay::Intersection_of_constraints_exception&) {
    return false;
  }
  writeTriangles(mesh, out);
  return true;
}

} // namespace qmesh
