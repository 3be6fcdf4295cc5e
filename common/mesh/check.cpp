// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/check.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesh/tile_frame.h"

namespace qmesh {

namespace {

std::string triangleName(std::size_t t) {
  return "triangle " + std::to_string(t);
}

std::string checkVertices(const Tin& tin) {
  if (tin.vertices.size() == kForbiddenVertexCount)
    return "the mesh has exactly 65536 vertices";
  std::vector<bool> used(tin.vertices.size(), false);
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    for (std::uint32_t index : tin.triangles[t]) {
      if (index >= tin.vertices.size())
        return triangleName(t) + " names vertex " + std::to_string(index) + " of " +
               std::to_string(tin.vertices.size());
      used[index] = true;
    }
  }
  std::vector<std::uint32_t> places;
  places.reserve(tin.vertices.size());
  for (std::size_t k = 0; k < tin.vertices.size(); ++k) {
    const TinVertex& vertex = tin.vertices[k];
    if (!used[k])
      return "vertex " + std::to_string(k) + " is in no triangle";
    if (std::max({vertex.u, vertex.v, vertex.q}) > kQuantizedMax)
      return "vertex " + std::to_string(k) + " lies beyond 32767";
    places.push_back(std::uint32_t(vertex.v) << 16 | vertex.u);
  }
  std::sort(places.begin(), places.end());
  const auto twice = std::adjacent_find(places.begin(), places.end());
  if (twice != places.end())
    return "two vertices lie at u " + std::to_string(*twice & 0xffff) + ", v " +
           std::to_string(*twice >> 16);
  return {};
}

std::string checkAreas(const Tin& tin) {
  std::int64_t sum = 0;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const TinVertex& a = tin.vertices[tin.triangles[t][0]];
    const TinVertex& b = tin.vertices[tin.triangles[t][1]];
    const TinVertex& c = tin.vertices[tin.triangles[t][2]];
    const std::int64_t area =
        std::int64_t(b.u - a.u) * (c.v - a.v) - std::int64_t(b.v - a.v) * (c.u - a.u);
    if (area <= 0)
      return triangleName(t) + (area < 0 ? " is clockwise" : " has no area");
    sum += area;
  }
  constexpr std::int64_t square = std::int64_t(2) * kQuantizedMax * kQuantizedMax;
  if (sum != square)
    return "the triangles' doubled areas sum to " + std::to_string(sum) + ", the square's is " +
           std::to_string(square);
  return {};
}

/// A directed edge of a triangle, named so that both directions sort side by side.
struct DirectedEdge {
  std::uint32_t low;
  std::uint32_t high;
  bool upwards;

  bool operator<(const DirectedEdge& o) const {
    return low != o.low ? low < o.low : high != o.high ? high < o.high : upwards < o.upwards;
  }
  bool joins(const DirectedEdge& o) const { return low == o.low && high == o.high; }
};

bool onBorder(const TinVertex& a, const TinVertex& b) {
  return (a.u == b.u && (a.u == 0 || a.u == kQuantizedMax)) ||
         (a.v == b.v && (a.v == 0 || a.v == kQuantizedMax));
}

std::string checkEdges(const Tin& tin) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * tin.triangles.size());
  for (const TinTriangle& triangle : tin.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    while (end < edges.size() && edges[end].joins(edges[first]))
      ++end;
    const std::string name = "the edge of vertices " + std::to_string(edges[first].low) + " and " +
                             std::to_string(edges[first].high);
    if (end - first > 2)
      return name + " belongs to more than two triangles";
    if (end - first == 2 && edges[first].upwards == edges[first + 1].upwards)
      return name + " runs the same way in both its triangles";
    if (end - first == 1 &&
        !onBorder(tin.vertices[edges[first].low], tin.vertices[edges[first].high]))
      return name + " has one triangle but is not on the border";
  }
  return {};
}

} // namespace

std::string checkTin(const Tin& tin) {
  std::string fault = checkVertices(tin);
  if (fault.empty())
    fault = checkAreas(tin);
  if (fault.empty())
    fault = checkEdges(tin);
  return fault;
}

} // namespace qmesh
