// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/normals.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geo/ellipsoid.h"
#include "geo/octahedral.h"
#include "terrain.h"

namespace qmesh {
namespace {

using namespace test;

bool same(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

TEST(NodeNormal, IsTheEllipsoidsOnAFlatTile) {
  for (const Place& place : places()) {
    SCOPED_TRACE(testing::Message() << place);
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
    const HeightTile tile = patch.tile();
    for (int j = 0; j <= place.cells; ++j) {
      for (int i = 0; i <= place.cells; ++i) {
        const Vec3 expected = wgs84::normal(place.lattice().longitude(tile.column0() + i),
                                            place.lattice().latitude(tile.row0() + j));
        ASSERT_LT(length(nodeNormal(tile, i, j) - expected), 1e-12);
      }
    }
  }
}

// The cross product of two chords of the surface in ECEF: another road to the same normal.
TEST(NodeNormal, AgreesWithChordsInSpace) {
  for (const Place& place :
       {Place{Profile::geodetic, 10, 900, 700, 64}, Place{Profile::mercator, 12, 900, 2700, 64}}) {
    const NodeLattice lattice = place.lattice();
    const TerrainPatch patch(lattice, place.id(), 1, 1, Terrain::fractal, 5);
    const HeightTile tile = patch.tile();
    const auto point = [&](int i, int j) {
      return wgs84::toEcef(lattice.longitude(tile.column0() + i), lattice.latitude(tile.row0() + j),
                           tile.at(i, j));
    };
    for (int j = 0; j <= 64; j += 5) {
      for (int i = 0; i <= 64; i += 3) {
        const Vec3 east = point(i + 1, j) - point(i - 1, j);
        const Vec3 north = point(i, j + 1) - point(i, j - 1);
        const Vec3 cross{east.y * north.z - east.z * north.y, east.z * north.x - east.x * north.z,
                         east.x * north.y - east.y * north.x};
        EXPECT_LT(length(nodeNormal(tile, i, j) - normalized(cross)), 2e-3) << i << " " << j;
      }
    }
  }
}

//   data | fill: the cliff between them must not tilt the normals of either side
TEST(NodeNormal, DoesNotLookAcrossTheOutlineOfTheData) {
  const NodeLattice lattice(Scheme(Profile::geodetic), 12, 8);
  constexpr int kEdge = 8 + 1 + 2 * kTileHalo;
  std::vector<float> heights(kEdge * kEdge);
  std::vector<std::uint8_t> filled(kEdge * kEdge);
  const auto isFill = [](int i) { return i >= 5; };
  for (int j = -kTileHalo; j <= 8 + kTileHalo; ++j) {
    for (int i = -kTileHalo; i <= 8 + kTileHalo; ++i) {
      const auto node = std::size_t((j + kTileHalo) * kEdge + i + kTileHalo);
      heights[node] = isFill(i) ? 0.0f : float(1000 + 3 * i);
      filled[node] = isFill(i) ? 1 : 0;
    }
  }
  const std::ptrdiff_t origin = kTileHalo * kEdge + kTileHalo;
  const HeightTile tile({12, 4000, 3000}, lattice, heights.data() + origin, kEdge,
                        filled.data() + origin);
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i) {
      const double lon = lattice.longitude(tile.column0() + i);
      const double lat = lattice.latitude(tile.row0() + j);
      const double metres = lattice.spacingDegrees() * wgs84::metresPerDegreeEast(lat);
      const double slope = isFill(i) ? 0 : 3 / metres;
      const Vec3 expected = normalized(wgs84::enuToEcef(lon, lat, -slope, 0, 1));
      EXPECT_LT(length(nodeNormal(tile, i, j) - expected), 1e-9) << i << " " << j;
    }
  }
}

TEST(NodeNormal, IsTheSameInBothTilesOfAnEdge) {
  using P = Profile;
  for (const Place& place : {Place{P::geodetic, 3, 15, 4, 16}, Place{P::geodetic, 0, 1, 0, 16},
                             Place{P::mercator, 2, 3, 1, 32}, Place{P::geodetic, 11, 100, 2046, 16},
                             Place{P::mercator, 0, 0, 0, 8}}) {
    SCOPED_TRACE(testing::Message() << place);
    const bool twoRows = place.y + 1 < place.lattice().scheme().tilesY(place.zoom);
    const TerrainPatch patch(place.lattice(), place.id(), 2, twoRows ? 2 : 1, Terrain::ridged, 5);
    const int n = place.cells;
    for (int k = 0; k <= n; ++k) {
      EXPECT_TRUE(same(nodeNormal(patch.tile(0, 0), n, k), nodeNormal(patch.tile(1, 0), 0, k)));
      if (twoRows) {
        EXPECT_TRUE(same(nodeNormal(patch.tile(0, 0), k, n), nodeNormal(patch.tile(0, 1), k, 0)));
      }
    }
  }
}

TEST(NodeNormal, IsTheAxisAtThePoles) {
  for (const std::uint32_t y : {0u, 7u}) {
    const Place place{Profile::geodetic, 3, 2, y, 16};
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 1);
    for (int i = 0; i <= 16; ++i) {
      const Vec3 normal = nodeNormal(patch.tile(), i, y == 0 ? 0 : 16);
      EXPECT_TRUE(same(normal, {0, 0, y == 0 ? -1.0 : 1.0}));
    }
  }
}

TEST(OctNormals, EncodesTheNodeOfEveryVertex) {
  for (const Place& place : places()) {
    SCOPED_TRACE(testing::Message() << place);
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 2);
    const HeightTile tile = patch.tile();
    TileFrame frame;
    frame.reset(tile, place.level(5));
    Tin tin;
    std::vector<std::uint8_t> expected;
    for (int j = 0; j <= place.cells; j += 4) {
      for (int i = place.cells; i >= 0; i -= 2) {
        tin.vertices.push_back({frame.u(i), frame.v(j), 0});
        for (const std::uint8_t byte : octEncode(nodeNormal(tile, i, j)))
          expected.push_back(byte);
      }
    }
    EXPECT_EQ(octNormals(tile, frame, tin), expected);
  }
}

} // namespace
} // namespace qmesh
