// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/mesh_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "codec/format.h"
#include "geo/ellipsoid.h"

namespace qmesh {

namespace {

constexpr int kMax = format::kQuantizedMax;
constexpr const char* kSides[] = {"west", "south", "east", "north"};

/// Counts cases of one kind and keeps the first for its words.
struct Cases {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t which) {
    if (count++ == 0)
      first = which;
  }
};

std::string countText(const Cases& cases, const char* one, const char* many) {
  return std::to_string(cases.count) + " " + (cases.count == 1 ? one : many) + ", the first is " +
         std::to_string(cases.first);
}

/// What is found about one mesh.
class MeshCheck {
 public:
  MeshCheck(const TileMesh& mesh, const TileContext& context, Findings& findings)
      : mesh_(mesh), context_(context), findings_(findings) {}

  void run() {
    if (mesh_.vertexCount() == format::kAmbiguousVertices)
      add(217, "");
    checkVertices();
    checkTriangles();
    checkEdges();
    checkSag();
    checkLists();
  }

 private:
  void add(int code, const std::string& what) { findings_.push_back({code, context_.place, what}); }
  void checkVertices();
  void checkTriangles();
  void checkEdges();
  void checkSag();
  void checkLists();
  bool onSide(std::uint32_t a, std::uint32_t b) const;
  bool isOn(std::size_t side, std::size_t vertex) const;

  const TileMesh& mesh_;
  const TileContext& context_;
  Findings& findings_;
  std::int64_t area_ = 0; ///< doubled, of all triangles, those turned round negative
  bool proper_ = true;    ///< no vertex or triangle is at fault
};

void MeshCheck::checkVertices() {
  std::vector<std::uint8_t> used(mesh_.vertexCount(), 0);
  for (const std::uint32_t index : mesh_.indices)
    used[index] = 1;
  Cases unused;
  std::vector<std::uint32_t> places(mesh_.vertexCount());
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!used[k])
      unused.add(k);
    places[k] = std::uint32_t(mesh_.v[k]) << 16 | mesh_.u[k];
  }
  if (unused.count > 0)
    add(304, countText(unused, "vertex", "vertices"));
  std::sort(places.begin(), places.end());
  std::size_t twice = 0;
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k] == places[k - 1] && ++twice == 1)
      add(303,
          "u " + std::to_string(places[k] & 0xffff) + ", v " + std::to_string(places[k] >> 16));
  proper_ = twice == 0;
}

void MeshCheck::checkTriangles() {
  Cases flat, flipped;
  for (std::size_t t = 0; t < mesh_.triangleCount(); ++t) {
    const std::uint32_t* corner = &mesh_.indices[3 * t];
    const int u = mesh_.u[corner[0]], v = mesh_.v[corner[0]];
    const std::int64_t area = std::int64_t(mesh_.u[corner[1]] - u) * (mesh_.v[corner[2]] - v) -
                              std::int64_t(mesh_.v[corner[1]] - v) * (mesh_.u[corner[2]] - u);
    if (area <= 0)
      (area == 0 ? flat : flipped).add(t);
    area_ += area;
  }
  if (flat.count > 0)
    add(301, countText(flat, "triangle", "triangles"));
  if (flipped.count > 0)
    add(302, countText(flipped, "triangle", "triangles"));
  proper_ = proper_ && flat.count + flipped.count == 0;
}

bool MeshCheck::isOn(std::size_t side, std::size_t vertex) const {
  const int value = side % 2 == 0 ? mesh_.u[vertex] : mesh_.v[vertex];
  return value == (side < 2 ? 0 : kMax);
}

bool MeshCheck::onSide(std::uint32_t a, std::uint32_t b) const {
  for (std::size_t side = 0; side < 4; ++side)
    if (isOn(side, a) && isOn(side, b))
      return true;
  return false;
}

/// Directed edges sorted by their lower vertex (a counting sort), each group searched for pairs.
void MeshCheck::checkEdges() {
  struct Edge {
    std::uint32_t high;
    bool upwards;
  };
  std::vector<std::uint32_t> begin(mesh_.vertexCount() + 1, 0);
  const auto eachEdge = [&](auto take) {
    for (std::size_t t = 0; t < mesh_.triangleCount(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh_.indices[3 * t + k], b = mesh_.indices[3 * t + (k + 1) % 3];
        take(std::min(a, b), std::max(a, b), a < b);
      }
  };
  eachEdge([&](std::uint32_t low, std::uint32_t, bool) { ++begin[low + 1]; });
  for (std::size_t k = 1; k < begin.size(); ++k)
    begin[k] += begin[k - 1];
  std::vector<Edge> edges(mesh_.indices.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  eachEdge([&](std::uint32_t low, std::uint32_t high, bool upwards) {
    edges[next[low]++] = {high, upwards};
  });
  Cases lone, bad;
  for (std::uint32_t low = 0; low + 1 < begin.size(); ++low) {
    const auto first = edges.begin() + begin[low], end = edges.begin() + begin[low + 1];
    if (end - first > 32) // a fan: rare, but not to be quadratic
      std::sort(first, end, [](const Edge& a, const Edge& b) { return a.high < b.high; });
    for (auto edge = first; edge != end; ++edge) {
      const auto same = [&](const Edge& other) { return other.high == edge->high; };
      const auto window = end - first > 32 ? std::max(first, edge - 3) : first;
      if (std::any_of(window, edge, same))
        continue;
      const auto stop = end - first > 32 ? std::min(end, edge + 4) : end;
      const auto count = std::count_if(edge, stop, same);
      const auto ups =
          std::count_if(edge, stop, [&](const Edge& e) { return same(e) && e.upwards; });
      if (count == 1 && !onSide(low, edge->high))
        lone.add(low);
      else if (count > 2 || (count == 2 && ups != 1))
        bad.add(low);
    }
  }
  if (!proper_)
    return; // follows from the vertices and triangles at fault
  if (bad.count > 0)
    add(305,
        std::to_string(bad.count) + " edges, the first at vertex " + std::to_string(bad.first));
  constexpr std::int64_t kSquare = std::int64_t(2) * kMax * kMax;
  const bool covers = area_ == kSquare;
  const std::string share = formatNumber(std::round(1e6 * double(area_) / double(kSquare)) / 1e4);
  if (bad.count == 0 && !covers)
    add(307, "triangles have " + share + " % of the square's area");
  else if (bad.count == 0 && lone.count > 0)
    add(306,
        std::to_string(lone.count) + " edges, the first at vertex " + std::to_string(lone.first));
}

/// A chord of length L lies L^2 / (8 R) below the sphere.
void MeshCheck::checkSag() {
  const GeoBox& box = context_.box;
  const double middle = (box.south + box.north) / 2;
  const double perU = (box.east - box.west) / kMax * wgs84::kRadiansPerDegree * wgs84::kSemiMajor *
                      std::cos(middle * wgs84::kRadiansPerDegree);
  const double perV = (box.north - box.south) / kMax * wgs84::kRadiansPerDegree * wgs84::kSemiMajor;
  double longest = 0;
  for (std::size_t k = 0; k < mesh_.indices.size(); ++k) {
    const std::uint32_t a = mesh_.indices[k], b = mesh_.indices[k % 3 == 2 ? k - 2 : k + 1];
    const double east = (mesh_.u[a] - mesh_.u[b]) * perU, north = (mesh_.v[a] - mesh_.v[b]) * perV;
    longest = std::max(longest, east * east + north * north);
  }
  const double sag = longest / (8 * wgs84::kSemiMajor);
  if (sag > context_.geometricError)
    add(309, "an edge of " + formatNumber(std::round(std::sqrt(longest) / 1000)) + " km lies " +
                 formatNumber(std::round(sag)) + " m deep");
}

void MeshCheck::checkLists() {
  std::array<std::vector<std::uint32_t>, 4> listed = mesh_.edges, present;
  for (std::size_t side = 0; side < 4; ++side) {
    std::sort(listed[side].begin(), listed[side].end());
    for (std::uint32_t k = 0; k < mesh_.vertexCount(); ++k)
      if (isOn(side, k))
        present[side].push_back(k);
  }
  if (listed == present)
    return;
  auto sortedListed = listed, sortedPresent = present;
  std::sort(sortedListed.begin(), sortedListed.end());
  std::sort(sortedPresent.begin(), sortedPresent.end());
  if (sortedListed == sortedPresent) {
    add(209, "");
    return;
  }
  std::string sides;
  for (std::size_t side = 0; side < 4; ++side)
    if (listed[side] != present[side])
      sides += (sides.empty() ? "" : "; ") + std::string(kSides[side]) + " lists " +
               std::to_string(listed[side].size()) + " of " + std::to_string(present[side].size());
  add(208, sides);
}

} // namespace

void checkMesh(const TileMesh& mesh, const TileContext& context, Findings& findings) {
  MeshCheck(mesh, context, findings).run();
}

} // namespace qmesh
