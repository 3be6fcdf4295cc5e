// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/normals.h"

#include <algorithm>

#include "geo/ellipsoid.h"
#include "geo/octahedral.h"

namespace qmesh {

namespace {

/// The rise of the heights beside a node, and from which offset to which it was taken.
struct Difference {
  double rise = 0;
  int from = 0;
  int to = 0;
};

/// Central difference along (di, dj). A side that does not exist, or lies across the outline of the
/// data, gives way to the node itself: the cliff down to a fill is not terrain.
Difference differenceAt(const HeightTile& tile, int i, int j, int di, int dj) {
  const bool filled = tile.isFilled(i, j);
  const auto usable = [&](int side) {
    const int row = j + side * dj;
    return row >= tile.firstRow() && row <= tile.lastRow() &&
           tile.isFilled(i + side * di, row) == filled;
  };
  const int from = usable(-1) ? -1 : 0;
  const int to = usable(1) ? 1 : 0;
  return {double(tile.at(i + to * di, j + to * dj)) - tile.at(i + from * di, j + from * dj), from,
          to};
}

} // namespace

Vec3 nodeNormal(const HeightTile& tile, int i, int j) {
  const NodeLattice& lattice = tile.lattice();
  const std::int64_t row = tile.row0() + j;
  if (lattice.isPole(row))
    return {0, 0, row == 0 ? -1.0 : 1.0};

  const double latitude = lattice.latitude(row);
  const Difference east = differenceAt(tile, i, j, 1, 0);
  const Difference north = differenceAt(tile, i, j, 0, 1);
  const double eastDegrees = (east.to - east.from) * lattice.spacingDegrees();
  const double northDegrees = lattice.latitude(row + north.to) - lattice.latitude(row + north.from);
  const auto slope = [](double rise, double degrees, double metresPerDegree) {
    return degrees > 0 ? rise / (degrees * metresPerDegree) : 0;
  };
  return normalized(
      wgs84::enuToEcef(lattice.longitude(tile.column0() + i), latitude,
                       -slope(east.rise, eastDegrees, wgs84::metresPerDegreeEast(latitude)),
                       -slope(north.rise, northDegrees, wgs84::metresPerDegreeNorth(latitude)), 1));
}

std::vector<std::uint8_t> octNormals(const HeightTile& tile, const TileFrame& frame,
                                     const Tin& tin) {
  std::vector<std::uint8_t> normals;
  normals.reserve(2 * tin.vertices.size());
  for (const TinVertex& vertex : tin.vertices) {
    const Vec3 normal = nodeNormal(tile, frame.nearestColumn(vertex.u), frame.nearestRow(vertex.v));
    for (std::uint8_t byte : octEncode(normal))
      normals.push_back(byte);
  }
  return normals;
}

} // namespace qmesh
