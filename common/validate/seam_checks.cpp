// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/seam_checks.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "codec/format.h"
#include "surface/surface_raster.h"

namespace qmesh {

namespace {

constexpr double kSame = 1e-3; ///< metres: the float32 of the header

std::string metres(double value) {
  return formatNumber(std::round(value * 10000) / 10000) + " m";
}

/// Height of the polyline at a position between its ends.
double heightAt(const TileEdge& edge, double at) {
  const auto above = std::lower_bound(edge.at.begin(), edge.at.end(), at);
  if (above == edge.at.end())
    return edge.heights.back();
  const auto k = std::size_t(above - edge.at.begin());
  if (*above == at || k == 0)
    return edge.heights[k];
  const double t = (at - edge.at[k - 1]) / double(edge.at[k] - edge.at[k - 1]);
  return edge.heights[k - 1] + t * (edge.heights[k] - edge.heights[k - 1]);
}

/// The largest distance of the two polylines: it lies at a vertex of one of them.
double largestGap(const TileEdge& a, const TileEdge& b) {
  double gap = 0;
  for (std::size_t k = 0; k < a.at.size(); ++k)
    gap = std::max(gap, std::abs(a.heights[k] - heightAt(b, a.at[k])));
  for (std::size_t k = 0; k < b.at.size(); ++k)
    gap = std::max(gap, std::abs(b.heights[k] - heightAt(a, b.at[k])));
  return gap;
}

} // namespace

std::array<TileEdge, 4> tileEdges(const TileMesh& mesh) {
  std::array<TileEdge, 4> edges;
  const double step = std::abs(double(mesh.header.maxHeight) - double(mesh.header.minHeight)) /
                      format::kQuantizedMax;
  for (std::size_t side = 0; side < 4; ++side) {
    const auto& across = side % 2 == 0 ? mesh.u : mesh.v;
    const auto& along = side % 2 == 0 ? mesh.v : mesh.u;
    const int line = side < 2 ? 0 : format::kQuantizedMax;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t k = 0; k < mesh.vertexCount(); ++k)
      if (across[k] == line)
        vertices.push_back(k);
    std::sort(vertices.begin(), vertices.end(),
              [&](std::uint32_t a, std::uint32_t b) { return along[a] < along[b]; });
    TileEdge& edge = edges[side];
    edge.step = step;
    for (const std::uint32_t k : vertices) {
      edge.at.push_back(along[k]);
      edge.heights.push_back(decodedHeight(mesh.header, mesh.q[k]));
      if (!mesh.extensions.normals.empty())
        edge.normals.push_back(
            {mesh.extensions.normals[2 * k], mesh.extensions.normals[2 * k + 1]});
    }
  }
  return edges;
}

void checkSeam(const TileEdge& a, const TileEdge& b, const std::string& place, SeamReport& report,
               Findings& findings) {
  if (a.at.empty() || b.at.empty())
    return; // a mesh that does not reach its border: said of the tile
  ++report.seams;
  const bool sameVertices = a.at == b.at;
  if (!sameVertices)
    findings.push_back(
        {501, place,
         std::to_string(a.at.size()) + " and " + std::to_string(b.at.size()) + " vertices"});
  const double gap = largestGap(a, b);
  report.largestGap = std::max(report.largestGap, gap);
  // Where the vertices differ each side may be as far off as both round.
  if (gap > a.step + b.step + kSame)
    findings.push_back({503, place, "the heights differ by up to " + metres(gap)});
  else if (gap > kSame)
    findings.push_back({502, place, "the heights differ by up to " + metres(gap)});
  if (!sameVertices || a.normals.empty() || b.normals.empty())
    return;
  std::size_t differ = 0;
  for (std::size_t k = 0; k < a.normals.size(); ++k)
    differ += a.normals[k] != b.normals[k];
  if (differ > 0)
    findings.push_back(
        {504, place,
         std::to_string(differ) + " of " + std::to_string(a.normals.size()) + " normals"});
}

void checkPole(const std::vector<const TileEdge*>& row, const std::string& place,
               Findings& findings) {
  double low = 0, high = 0, step = 0;
  bool begun = false;
  for (const TileEdge* edge : row) {
    step = std::max(step, edge->step);
    for (const double height : edge->heights) {
      low = begun ? std::min(low, height) : height;
      high = begun ? std::max(high, height) : height;
      begun = true;
    }
  }
  if (high - low > 2 * step + kSame)
    findings.push_back({505, place, metres(low) + " to " + metres(high)});
}

} // namespace qmesh
