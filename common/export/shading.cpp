// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "export/shading.h"

#include <algorithm>
#include <cmath>

#include "export/mesh_places.h"
#include "geo/ellipsoid.h"

namespace qmesh {

namespace {

struct Stop {
  double at; ///< 0 lowest, 1 highest
  std::array<double, 3> colour;
};
constexpr Stop kRamp[] = {
    {0.00, {112, 158, 107}}, {0.25, {178, 196, 132}}, {0.50, {222, 204, 150}},
    {0.75, {176, 138, 106}}, {1.00, {250, 248, 246}},
};

/// The light of hill shading: from the north-west, 45 degrees high; east, north, up.
constexpr Vec3 kLight = {-0.5, 0.5, 0.70710678118654752};

std::array<double, 3> rampColour(double at) {
  const Stop* high = kRamp + 1;
  while (high + 1 < std::end(kRamp) && at > high->at)
    ++high;
  const Stop& low = *(high - 1);
  const double t = std::clamp((at - low.at) / (high->at - low.at), 0.0, 1.0);
  std::array<double, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k)
    colour[k] = low.colour[k] + t * (high->colour[k] - low.colour[k]);
  return colour;
}

Rgb rounded(const std::array<double, 3>& colour, double light) {
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = std::uint8_t(std::clamp(std::floor(colour[k] * light + 0.5), 0.0, 255.0));
  return out;
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The upward normal of a triangle on a flat map in metres; straight up where it has no area.
Vec3 mapNormal(const ExportMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const double latitude = (mesh.box.south + mesh.box.north) / 2;
  const double perLon = wgs84::metresPerDegreeEast(latitude);
  const double perLat = wgs84::metresPerDegreeNorth(latitude);
  std::array<Vec3, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place place = placeOf(mesh, mesh.vertices[triangle[k]]);
    at[k] = {place.lon * perLon, place.lat * perLat, place.height};
  }
  const Vec3 normal = cross(at[1] - at[0], at[2] - at[0]);
  const double size = length(normal);
  if (!(size > 0))
    return {0, 0, 1};
  return normal * ((normal.z < 0 ? -1 : 1) / size);
}

} // namespace

std::vector<Rgb> triangleColours(const ExportMesh& mesh, MeshShade shade) {
  double low = 0, range = 0;
  if (!mesh.vertices.empty()) {
    const auto byHeight = [](const auto& a, const auto& b) { return a.height < b.height; };
    const auto ends = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(), byHeight);
    low = ends.first->height;
    range = ends.second->height - low;
  }
  std::vector<Rgb> colours;
  colours.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    if (shade == MeshShade::none) {
      colours.push_back({255, 255, 255});
      continue;
    }
    const Vec3 normal = mapNormal(mesh, triangle);
    if (shade == MeshShade::slope) {
      colours.push_back(rounded({255, 255, 255}, 0.15 + 0.85 * normal.z));
      continue;
    }
    double sum = 0;
    for (const std::uint32_t k : triangle)
      sum += mesh.vertices[k].height;
    const double at = range > 0 ? (sum / 3 - low) / range : 0;
    const double light = 0.55 + 0.45 * std::max(0.0, dot(normal, kLight)) / kLight.z;
    colours.push_back(rounded(rampColour(at), light));
  }
  return colours;
}

std::string hexColour(const Rgb& colour) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : colour) {
    text += kDigits[part >> 4];
    text += kDigits[part & 15];
  }
  return text;
}

} // namespace qmesh
