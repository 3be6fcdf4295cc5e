// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "export/mesh_places.h"

#include <algorithm>
#include <cmath>

#include "geo/ellipsoid.h"

namespace qmesh {

namespace {

constexpr double kUnits = 32767;

/// The east, north and up directions at a place, and its origin.
struct LocalFrame {
  Vec3 origin, east, north, up;

  Vec3 turn(const Vec3& d) const { return {dot(d, east), dot(d, north), dot(d, up)}; }
};

LocalFrame frameAt(double lon, double lat) {
  return {wgs84::toEcef(lon, lat, 0), wgs84::enuToEcef(lon, lat, 1, 0, 0),
          wgs84::enuToEcef(lon, lat, 0, 1, 0), wgs84::enuToEcef(lon, lat, 0, 0, 1)};
}

LocalFrame frameOf(const GeoBox& box) {
  return frameAt((box.west + box.east) / 2, (box.south + box.north) / 2);
}

void addEdges(const ExportMesh& mesh, Plan& plan) {
  std::vector<Plan::Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    while (end < edges.size() && edges[end] == edges[first])
      ++end;
    (end - first == 1 ? plan.border : plan.inner).push_back(edges[first]);
  }
}

} // namespace

Place placeOf(const ExportMesh& mesh, const ExportVertex& vertex) {
  const GeoBox& box = mesh.box;
  return {box.west + (box.east - box.west) * (vertex.u / kUnits),
          box.south + (box.north - box.south) * (vertex.v / kUnits), vertex.height};
}

std::vector<Vec3> positionsIn(const ExportMesh& mesh, MeshFrame frame) {
  const LocalFrame local = frameOf(mesh.box);
  std::vector<Vec3> positions;
  positions.reserve(mesh.vertices.size());
  for (const ExportVertex& vertex : mesh.vertices) {
    const Place place = placeOf(mesh, vertex);
    const Vec3 ecef = wgs84::toEcef(place.lon, place.lat, place.height);
    switch (frame) {
    case MeshFrame::local:
      positions.push_back(local.turn(ecef - local.origin));
      break;
    case MeshFrame::ecef:
      positions.push_back(ecef);
      break;
    case MeshFrame::lonlat:
      positions.push_back({place.lon, place.lat, place.height});
      break;
    }
  }
  return positions;
}

std::vector<Vec3> normalsIn(const ExportMesh& mesh, MeshFrame frame) {
  if (frame == MeshFrame::ecef)
    return mesh.normals;
  const LocalFrame local = frameOf(mesh.box);
  std::vector<Vec3> normals;
  normals.reserve(mesh.normals.size());
  for (std::size_t k = 0; k < mesh.normals.size(); ++k) {
    const Place place = placeOf(mesh, mesh.vertices[k]);
    const LocalFrame own = frame == MeshFrame::local ? local : frameAt(place.lon, place.lat);
    normals.push_back(own.turn(mesh.normals[k]));
  }
  return normals;
}

Plan planOf(const ExportMesh& mesh, int width) {
  constexpr int kNarrowest = 16;
  constexpr double kMostStretched = 4;
  const GeoBox& box = mesh.box;
  const double middle = (box.south + box.north) / 2;
  const double wide = (box.east - box.west) * wgs84::metresPerDegreeEast(middle);
  const double high = (box.north - box.south) * wgs84::metresPerDegreeNorth(middle);
  const double ratio = std::clamp(high / wide, 1 / kMostStretched, kMostStretched);
  Plan plan;
  plan.width = std::max(width, kNarrowest);
  plan.height = std::max(1, int(std::lround(plan.width * ratio)));
  plan.points.reserve(mesh.vertices.size());
  for (const ExportVertex& vertex : mesh.vertices)
    plan.points.push_back({vertex.u / kUnits * plan.width, (1 - vertex.v / kUnits) * plan.height});
  addEdges(mesh, plan);
  return plan;
}

} // namespace qmesh
