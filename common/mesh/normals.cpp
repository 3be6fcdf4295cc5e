// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/normals.h"

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

/// What the normals of a row of nodes have in common.
struct RowFrame {
  Vec3 up; ///< of the ellipsoid where the row crosses the meridian of Greenwich: no y
  double metresPerDegreeEast = 0;
  double metresPerDegreeNorth = 0;
  double latitudes[3] = {}; ///< degrees, of the row to the south, of this one, of that to the north
};

RowFrame rowFrame(const HeightTile& tile, int j) {
  const NodeLattice& lattice = tile.lattice();
  RowFrame frame;
  for (int side = -1; side <= 1; ++side) {
    if (j + side >= tile.firstRow() && j + side <= tile.lastRow())
      frame.latitudes[side + 1] = lattice.latitude(tile.row0() + j + side);
  }
  const double latitude = frame.latitudes[1];
  frame.up = wgs84::normal(0, latitude);
  frame.metresPerDegreeEast = wgs84::metresPerDegreeEast(latitude);
  frame.metresPerDegreeNorth = wgs84::metresPerDegreeNorth(latitude);
  return frame;
}

/// The direction of the equator's normal on the meridian of a column of nodes: no z.
Vec3 meridianOf(const HeightTile& tile, int i) {
  return wgs84::normal(tile.lattice().longitude(tile.column0() + i), 0);
}

Vec3 normalAt(const HeightTile& tile, int i, int j, const RowFrame& row, const Vec3& meridian) {
  if (tile.lattice().isPole(tile.row0() + j))
    return {0, 0, tile.row0() + j == 0 ? -1.0 : 1.0};

  const Difference east = differenceAt(tile, i, j, 1, 0);
  const Difference north = differenceAt(tile, i, j, 0, 1);
  const double eastDegrees = (east.to - east.from) * tile.lattice().spacingDegrees();
  const double northDegrees = row.latitudes[north.to + 1] - row.latitudes[north.from + 1];
  const auto slope = [](double rise, double degrees, double metresPerDegree) {
    return degrees > 0 ? rise / (degrees * metresPerDegree) : 0;
  };
  const double eastward = -slope(east.rise, eastDegrees, row.metresPerDegreeEast);
  const double northward = -slope(north.rise, northDegrees, row.metresPerDegreeNorth);
  // (eastward, northward, 1) turned from the local frame, first about the equator's axis, then
  // about the pole's.
  const double outward = row.up.x - row.up.z * northward;
  return normalized({meridian.x * outward - meridian.y * eastward,
                     meridian.y * outward + meridian.x * eastward,
                     row.up.z + row.up.x * northward});
}

/// Values by index, each made when first asked for.
template <class Value> class Lazily {
 public:
  explicit Lazily(int count) : values_(std::size_t(count)), made_(std::size_t(count), false) {}

  template <class Make> const Value& at(int index, Make make) {
    const auto k = std::size_t(index);
    if (!made_[k]) {
      values_[k] = make();
      made_[k] = true;
    }
    return values_[k];
  }

 private:
  std::vector<Value> values_;
  std::vector<bool> made_;
};

} // namespace

Vec3 nodeNormal(const HeightTile& tile, int i, int j) {
  return normalAt(tile, i, j, rowFrame(tile, j), meridianOf(tile, i));
}

std::vector<std::uint8_t> octNormals(const HeightTile& tile, const TileFrame& frame,
                                     const Tin& tin) {
  Lazily<RowFrame> rows(tile.cells() + 1);
  Lazily<Vec3> meridians(tile.cells() + 1);
  std::vector<std::uint8_t> normals;
  normals.reserve(2 * tin.vertices.size());
  for (const TinVertex& vertex : tin.vertices) {
    const int i = frame.nearestColumn(vertex.u), j = frame.nearestRow(vertex.v);
    const RowFrame& row = rows.at(j, [&] { return rowFrame(tile, j); });
    const Vec3& meridian = meridians.at(i, [&] { return meridianOf(tile, i); });
    for (std::uint8_t byte : octEncode(normalAt(tile, i, j, row, meridian)))
      normals.push_back(byte);
  }
  return normals;
}

} // namespace qmesh
