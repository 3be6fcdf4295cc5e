// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/point_set_method.h"

#include <algorithm>

#include "geo/ellipsoid.h"
#include "simplify/cgal/line_simplify.h"
#include "simplify/cgal/tile_shuffle.h"
#include "simplify/finish.h"

namespace qmesh {

namespace {

/// The nodes of an edge in ascending order are first + k * step, k = 0..N.
struct EdgeNodes {
  NodeIndex first;
  NodeIndex step;
};

EdgeNodes nodesOf(const NodeGrid& grid, Edge edge) {
  const int n = grid.cells();
  switch (edge) {
  case kWest:
    return {grid.index(0, 0), grid.index(0, 1)};
  case kSouth:
    return {grid.index(0, 0), 1};
  case kEast:
    return {grid.index(n, 0), grid.index(0, 1)};
  case kNorth:
    return {grid.index(0, n), 1};
  }
  return {};
}

/// The nodes at which lines may reach the border: those of its free edges.
std::vector<std::uint8_t> freeNodes(const NodeGrid& grid, const Border& border) {
  std::vector<std::uint8_t> mayEnd(grid.size(), 0);
  for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
    const EdgeNodes nodes = nodesOf(grid, edge);
    for (int k = 1; border.isFree[edge] && k < grid.cells(); ++k)
      mayEnd[std::size_t(nodes.first + k * nodes.step)] = 1;
  }
  return mayEnd;
}

} // namespace

double PointSetSite::relativeError() const {
  constexpr double kWidestRelief = 40000; // metres
  return level.maxError / std::min(tile.lattice().scheme().tileMetres(level.zoom), kWidestRelief);
}

double PointSetSite::share() const {
  const double inner = tile.cells() - 1.0;
  return 1 / (1 + inner * inner * relativeError());
}

double PointSetSite::area() const {
  const GeoBox box = tile.lattice().scheme().box(tile.id());
  const double latitude = (box.south + box.north) / 2;
  return (box.east - box.west) * wgs84::metresPerDegreeEast(latitude) * (box.north - box.south) *
         wgs84::metresPerDegreeNorth(latitude);
}

Vec3 PointSetSite::up() const {
  const GeoBox box = tile.lattice().scheme().box(tile.id());
  return wgs84::normal((box.west + box.east) / 2, (box.south + box.north) / 2);
}

PointSetMethod::PointSetMethod(const MethodOptions& options)
    : borderMaxError_(options.borderMaxError),
      borderMaxLength_(options.borderMaxLength), rules_{options.featureAngle,
                                                        options.featureMinSize} {}

/// The level as its edges are to be: their own max error, and a grid dense enough for the longest
/// piece.
LevelParams PointSetMethod::edgeLevel(const LevelParams& level, int cells) const {
  LevelParams edges = level;
  edges.maxError = borderMaxError_.valueOr(level.zoom, level.maxError);
  const double share = borderMaxLength_.valueOr(level.zoom, 100) / 100;
  while (edges.baseGrid < cells && edges.baseGrid * share < 1)
    edges.baseGrid *= 2;
  return edges;
}

void PointSetMethod::makeBorder(const HeightTile& tile, const TileFrame& frame,
                                const LevelParams& level, Border& border) const {
  qmesh::makeBorder(tile, frame, edgeLevel(level, tile.cells()), border);
}

Status PointSetMethod::simplify(const HeightTile& tile, const TileFrame& frame,
                                const Border& border, const LevelParams& level, Tin& out) {
  const PointSetSite site{tile, frame, level};
  const NodeGrid grid(tile.cells());
  positions_.reset(tile);
  parts_.lines = tracer_.trace(tile, positions_, rules_, freeNodes(grid, border));
  taken_.assign(grid.size(), 0);
  for (const NodeLine& line : parts_.lines) {
    for (const NodeIndex node : line)
      taken_[std::size_t(node)] = 1;
  }
  addFreeEdges(site, border);
  simplifyLines(tile, frame, BaseGrid(frame, level),
                borderMaxError_.valueOr(level.zoom, level.maxError), parts_.lines);

  parts_.nodes.clear();
  addBaseGrid(site);
  listPoints(site);
  if (!points_.empty())
    choose(site, points_);
  for (const NodePoint& point : points_)
    parts_.nodes.push_back(point.node);
  if (!makeConstrainedMesh(tile, frame, border, parts_, out))
    return tileFault(tile.id(), "two feature lines cross");
  finishTin(tile, frame, level, StopReason::parameter, out);
  return {};
}

/// A free edge is simplified with the features that end at it. Its given vertices stay, and enough
/// others for the longest piece.
void PointSetMethod::addFreeEdges(const PointSetSite& site, const Border& border) {
  const NodeGrid grid(site.tile.cells());
  const int baseCells = grid.cells() / edgeLevel(site.level, grid.cells()).baseGrid;
  for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
    if (!border.isFree[edge])
      continue;
    const EdgeNodes nodes = nodesOf(grid, edge);
    std::vector<std::uint8_t> stays(std::size_t(grid.cells()) + 1, 0);
    for (const std::uint16_t place : border[edge])
      stays[std::size_t(edge % 2 == 0 ? site.frame.nearestRow(place)
                                      : site.frame.nearestColumn(place))] = 1;
    NodeLine line;
    for (int k = 0; k <= grid.cells(); ++k) {
      line.push_back(nodes.first + k * nodes.step);
      if (line.size() > 1 && (k % baseCells == 0 || stays[std::size_t(k)])) {
        parts_.lines.push_back(line);
        line.assign(1, line.back());
      }
    }
  }
}

void PointSetMethod::addBaseGrid(const PointSetSite& site) {
  const NodeGrid grid(site.tile.cells());
  const int n = grid.cells(), step = n / site.level.baseGrid;
  for (int j = step; j < n; j += step) {
    for (int i = step; i < n; i += step) {
      parts_.nodes.push_back(grid.index(i, j));
      taken_[std::size_t(parts_.nodes.back())] = 1;
    }
  }
}

/// The inner nodes that are left, in the tile's own order.
void PointSetMethod::listPoints(const PointSetSite& site) {
  const NodeGrid grid(site.tile.cells());
  points_.clear();
  for (NodeIndex node = 0; node < NodeIndex(grid.size()); ++node) {
    if (grid.isInner(node) && !taken_[std::size_t(node)])
      points_.push_back({positions_.at(grid.column(node), grid.row(node)), node});
  }
  shuffleByTile(site.tile.id(), points_);
}

} // namespace qmesh
