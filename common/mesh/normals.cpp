// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/normals.h"

#include <algorithm>

#include "geo/ellipsoid.h"
#include "geo/octahedral.h"

namespace qmesh {

Vec3 nodeNormal(const HeightTile& tile, int i, int j) {
  const NodeLattice& lattice = tile.lattice();
  const std::int64_t row = tile.row0() + j;
  if (lattice.isPole(row))
    return {0, 0, row == 0 ? -1.0 : 1.0};

  const int south = std::max(j - 1, tile.firstRow());
  const int north = std::min(j + 1, tile.lastRow());
  const double latitude = lattice.latitude(row);
  const double eastMetres = 2 * lattice.spacingDegrees() * wgs84::metresPerDegreeEast(latitude);
  const double northMetres =
      (lattice.latitude(tile.row0() + north) - lattice.latitude(tile.row0() + south)) *
      wgs84::metresPerDegreeNorth(latitude);
  const double eastSlope = (double(tile.at(i + 1, j)) - tile.at(i - 1, j)) / eastMetres;
  const double northSlope = (double(tile.at(i, north)) - tile.at(i, south)) / northMetres;
  return normalized(wgs84::enuToEcef(lattice.longitude(tile.column0() + i), latitude, -eastSlope,
                                     -northSlope, 1));
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
