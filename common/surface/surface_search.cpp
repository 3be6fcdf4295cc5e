// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "surface/surface_search.h"

#include <algorithm>
#include <cmath>

#include "surface/surface_raster.h"

namespace qmesh {
namespace {

constexpr int kUnits = 32768;
constexpr int kMostBins = 512; ///< per edge
/// Bins a triangle may lie in on average, before bins are made larger.
constexpr std::size_t kMostEntries = 8;

int binOf(int unit, int side) {
  return unit * side / kUnits;
}

} // namespace

struct SurfaceSearch::BinRange {
  int x0, y0, x1, y1; ///< ends included
};

SurfaceSearch::SurfaceSearch(const TileMesh& mesh) : mesh_(&mesh) {
  const std::size_t count = mesh.triangleCount();
  side_ = std::clamp(int(std::sqrt(double(count))), 1, kMostBins);
  while (!countBins(kMostEntries * count) && side_ > 1) // slivers across the tile
    side_ /= 2;
  fillBins();
}

SurfaceSearch::BinRange SurfaceSearch::binsOf(std::size_t triangle) const {
  int u[3], v[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh_->indices[3 * triangle + k];
    u[k] = mesh_->u[vertex];
    v[k] = mesh_->v[vertex];
  }
  const auto [west, east] = std::minmax({u[0], u[1], u[2]});
  const auto [south, north] = std::minmax({v[0], v[1], v[2]});
  return {binOf(west, side_), binOf(south, side_), binOf(east, side_), binOf(north, side_)};
}

/// Entries per bin into begin_[bin + 1]; false as soon as there are more than `limit`.
bool SurfaceSearch::countBins(std::size_t limit) {
  begin_.assign(std::size_t(side_) * std::size_t(side_) + 1, 0);
  std::size_t entries = 0;
  for (std::size_t t = 0; t < mesh_->triangleCount(); ++t) {
    const BinRange bins = binsOf(t);
    entries += std::size_t(bins.x1 - bins.x0 + 1) * std::size_t(bins.y1 - bins.y0 + 1);
    if (entries > limit && side_ > 1)
      return false;
    for (int y = bins.y0; y <= bins.y1; ++y)
      for (int x = bins.x0; x <= bins.x1; ++x)
        ++begin_[std::size_t(y * side_ + x) + 1];
  }
  return true;
}

void SurfaceSearch::fillBins() {
  for (std::size_t bin = 1; bin < begin_.size(); ++bin)
    begin_[bin] += begin_[bin - 1];
  triangles_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t t = 0; t < mesh_->triangleCount(); ++t) {
    const BinRange bins = binsOf(t);
    for (int y = bins.y0; y <= bins.y1; ++y)
      for (int x = bins.x0; x <= bins.x1; ++x)
        triangles_[next[std::size_t(y * side_ + x)]++] = std::uint32_t(t);
  }
}

std::optional<double> SurfaceSearch::heightIn(std::size_t triangle, double u, double v) const {
  double du[3], dv[3], height[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh_->indices[3 * triangle + k];
    du[k] = mesh_->u[vertex] - u;
    dv[k] = mesh_->v[vertex] - v;
    height[k] = decodedHeight(mesh_->header, mesh_->q[vertex]);
  }
  // Twice the areas of the place with each edge: all of one sign inside.
  const double a = du[1] * dv[2] - du[2] * dv[1];
  const double b = du[2] * dv[0] - du[0] * dv[2];
  const double c = du[0] * dv[1] - du[1] * dv[0];
  const bool inside = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
  const double area = a + b + c;
  if (!inside || area == 0)
    return std::nullopt;
  return (a * height[0] + b * height[1] + c * height[2]) / area;
}

std::optional<double> SurfaceSearch::heightAt(double u, double v) const {
  if (!(u >= 0 && u < kUnits && v >= 0 && v < kUnits))
    return std::nullopt;
  const auto bin = std::size_t(binOf(int(v), side_) * side_ + binOf(int(u), side_));
  for (std::uint32_t k = begin_[bin]; k < begin_[bin + 1]; ++k)
    if (const auto height = heightIn(triangles_[k], u, v))
      return height;
  return std::nullopt;
}

} // namespace qmesh
