// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/node_lattice.h"

#include <gtest/gtest.h>

namespace qmesh {
namespace {

class EveryLattice : public testing::TestWithParam<Profile> {};

TEST_P(EveryLattice, NodesLieOnTileEdges) {
  const Scheme scheme(GetParam());
  for (const int zoom : {0, 1, 7, kMaxZoom}) {
    const NodeLattice lattice(scheme, zoom, 256);
    const TileId tile{zoom, scheme.tilesX(zoom) / 2, scheme.tilesY(zoom) / 2};
    const GeoBox box = scheme.box(tile);
    EXPECT_EQ(lattice.longitude(std::int64_t(tile.x) * 256), box.west);
    EXPECT_EQ(lattice.latitude(std::int64_t(tile.y) * 256), box.south);
    EXPECT_EQ(lattice.latitude(lattice.lastRow()), scheme.latitude(1, 1));
  }
}

TEST_P(EveryLattice, CoarserNodesAreEverySecondOne) {
  const NodeLattice fine(Scheme(GetParam()), 5, 64);
  const NodeLattice coarse = fine.coarser();
  for (std::int64_t i = 0; i < coarse.columns(); i += 7)
    EXPECT_EQ(coarse.longitude(i), fine.longitude(2 * i));
  for (std::int64_t j = 0; j <= coarse.lastRow(); ++j)
    EXPECT_EQ(coarse.latitude(j), fine.latitude(2 * j));
}

TEST_P(EveryLattice, ColumnsGoRoundTheGlobe) {
  const NodeLattice lattice(Scheme(GetParam()), 2, 16);
  const std::int64_t n = lattice.columns();
  EXPECT_EQ(lattice.longitude(0), -180);
  EXPECT_EQ(lattice.longitude(n), -180);
  EXPECT_EQ(lattice.wrap(-1), n - 1);
  EXPECT_EQ(lattice.wrap(-n), 0);
  EXPECT_EQ(lattice.longitude(-3), lattice.longitude(n - 3));
  EXPECT_EQ(lattice.spacingDegrees() * double(n), 360);
}

TEST_P(EveryLattice, PolesAreRowsOfTheGeodeticLatticeOnly) {
  const NodeLattice lattice(Scheme(GetParam()), 3, 8);
  const bool geodetic = GetParam() == Profile::geodetic;
  EXPECT_EQ(lattice.isPole(0), geodetic);
  EXPECT_EQ(lattice.isPole(lattice.lastRow()), geodetic);
  EXPECT_FALSE(lattice.isPole(1));
}

INSTANTIATE_TEST_SUITE_P(Profiles, EveryLattice,
                         testing::Values(Profile::geodetic, Profile::mercator));

} // namespace
} // namespace qmesh
