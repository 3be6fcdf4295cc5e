// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/level_params.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geo/ellipsoid.h"

namespace qmesh {
namespace {

const Scheme kGeodetic(Profile::geodetic);
const Scheme kMercator(Profile::mercator);

TEST(LatticeStep, IsOneMetreDownToZoomTwelveThenHalves) {
  for (int zoom = 0; zoom <= 12; ++zoom)
    EXPECT_EQ(latticeStep(kGeodetic, zoom, 1e6), 1) << zoom;
  EXPECT_EQ(latticeStep(kGeodetic, 13, 1e6), 0.5);
  EXPECT_EQ(latticeStep(kGeodetic, 14, 1e6), 0.25);
}

TEST(LatticeStep, IsAtMostHalfTheMaxErrorAndAPowerOfTwo) {
  // At zoom 16 tiles are 306 m: 1/16 m for 4 w, and not below 1/64 m for real relief.
  for (const double maxError : {100.0, 2.0, 0.1, 0.09, 0.04}) {
    const double step = latticeStep(kGeodetic, 16, maxError);
    EXPECT_LE(step, maxError / 2);
    EXPECT_TRUE(step == 1.0 / 16 || 2 * step > maxError / 2) << maxError;
    int exponent = 0;
    EXPECT_EQ(std::frexp(step, &exponent), 0.5);
  }
  EXPECT_EQ(latticeStep(kGeodetic, 16, 0.001), 1.0 / 64);
}

// P1 before P2: whatever the max error, terrain that is as steep as 45 degrees across the whole
// tile fits the lattice, so no tile of it takes a coarser step than its neighbours.
TEST(LatticeStep, HoldsRealReliefHoweverSmallTheMaxError) {
  for (const Scheme& scheme : {kGeodetic, kMercator}) {
    for (int zoom = 0; zoom <= 24; ++zoom) {
      const double relief = std::min(16000.0, scheme.tileMetres(zoom));
      EXPECT_GE(32767 * latticeStep(scheme, zoom, 0), relief) << zoom;
    }
  }
}

TEST(LatticeStep, StaysExactInTheHeader) {
  EXPECT_EQ(latticeStep(kGeodetic, 24, 0), 1.0 / 1024);
  EXPECT_EQ(latticeStep(kMercator, 24, 1e-9), 1.0 / 1024);
}

TEST(BaseGrid, IsThirtyTwoAtTheRootsByDefault) {
  EXPECT_EQ(baseGridOf(kGeodetic, 0, kGeodetic.geometricError(0) / 4, 256), 32);
}

TEST(BaseGrid, KeepsTheSagWithinTheMaxErrorAndIsTheSmallest) {
  for (const Scheme& scheme : {kGeodetic, kMercator}) {
    for (int zoom = 0; zoom <= 16; ++zoom) {
      const double maxError = scheme.geometricError(zoom) / 4;
      const double angle = 2 * wgs84::kPi / scheme.tilesX(zoom);
      const auto sag = [&](int cells) {
        const double side = angle / cells * wgs84::kSemiMajor;
        return side * side / (4 * wgs84::kSemiMajor);
      };
      const int cells = baseGridOf(scheme, zoom, maxError, 256);
      EXPECT_LE(sag(cells), maxError) << zoom;
      if (cells > 1) {
        EXPECT_GT(sag(cells / 2), maxError) << zoom;
      }
    }
  }
}

TEST(BaseGrid, HasNoMoreCellsThanTheTile) {
  EXPECT_EQ(baseGridOf(kGeodetic, 0, 0, 64), 64);
  EXPECT_EQ(baseGridOf(kGeodetic, 0, 1, 8), 8);
  EXPECT_EQ(baseGridOf(kGeodetic, 14, 10, 256), 1);
}

TEST(LevelParams, CollectsThem) {
  const LevelParams level = levelParams(kMercator, 3, 12, 128);
  EXPECT_EQ(level.zoom, 3);
  EXPECT_EQ(level.maxError, 12);
  EXPECT_EQ(level.latticeStep, latticeStep(kMercator, 3, 12));
  EXPECT_EQ(level.baseGrid, baseGridOf(kMercator, 3, 12, 128));
}

} // namespace
} // namespace qmesh
