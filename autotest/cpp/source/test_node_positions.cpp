// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// How far interpolated node positions are from a PROJ transform of every node, in many systems.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "source/node_positions.h"

namespace qmesh {
namespace {

struct Case {
  const char* name;
  const char* srs;
  double pixel;    ///< units of the system
  double lon, lat; ///< a place in the middle of what is sampled
  double reach;    ///< degrees to each side of it
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

const Case kCases[] = {
    {"utm1m", "EPSG:32632", 1, 11.2, 47, 0.5},
    {"utm10m", "EPSG:32632", 10, 11.2, 47, 1},
    {"utm30m", "EPSG:32632", 30, 11.2, 47, 2},
    {"utm90m", "EPSG:32632", 90, 9.0, 47, 3},
    {"utmNorth", "EPSG:32633", 30, 16, 78, 3},
    {"slovenia1m", "EPSG:3794", 1, 15.84, 46.45, 0.1},
    {"nad27", "EPSG:26710", 30, -122.2, 46.2, 1},
    {"nad27degrees", "EPSG:4267", 1.0 / 3600, -122.2, 46.2, 1},
    {"polarNorth", "EPSG:3413", 100, 30, 85, 4},
    {"polarPole", "EPSG:3413", 500, 0, 89.5, 180},
    {"polarSouth", "EPSG:3031", 200, 100, -75, 10},
    {"webMercator", "EPSG:3857", 30, 20, 60, 10},
    {"laeaEurope", "EPSG:3035", 25, 24, 64, 5},
    {"lambertFrance", "EPSG:2154", 5, 2.5, 46, 3},
    {"obliqueSwiss", "EPSG:2056", 2, 8.2, 46.8, 1},
    {"britain", "EPSG:27700", 50, -2, 54, 3},
    {"sinusoidal", "ESRI:54008", 1000, 60, 55, 20},
    {"mollweide", "ESRI:54009", 1000, -100, 60, 20},
};

/// The interpolated positions of a case and the exact ones.
class PositionsOf {
 public:
  /// On the lattice whose nodes are as close as the pixels, `coarser` zooms up.
  PositionsOf(const Case& c, Profile profile, int coarser)
      : case_(c), srs_(systemOf(c.srs)), exact_(*PointTransform::create(lonLatSrs(), srs_, c.name)),
        lattice_(latticeFor(c, profile, coarser)) {
    constexpr int kSize = 4000;
    double x = c.lon;
    double y = c.lat;
    EXPECT_TRUE(exact_.apply(x, y));
    const double half = c.pixel * kSize / 2;
    EXPECT_TRUE(
        frame_.set({x - half, c.pixel, 0, y + half, 0, -c.pixel}, kSize, kSize, fullTurn(srs_)));
  }

  /// Pixels, along x or y, at the nodes of some windows around the place.
  double worstError() {
    auto positions = makeTransformedPositions(lattice_, frame_, srs_, {-180, -90, 180, 90}, "");
    EXPECT_TRUE(positions.ok());
    std::mt19937 random(20260301);
    const auto share = [&] { return double(random()) / 2147483648.0 - 1; };
    const std::int64_t lastColumn = lattice_.columns() - kSide;
    const std::int64_t lastRow = lattice_.lastRow() + 1 - kSide;
    double worst = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const double lon = std::remainder(case_.lon + case_.reach * share(), 360);
      const double lat = case_.lat + std::min(case_.reach, 10.0) * share();
      const double i = (lon + 180) / lattice_.spacingDegrees();
      const double j =
          lattice_.scheme().fractionY(std::clamp(lat, -89.9, 89.9)) * double(lattice_.lastRow());
      worst = std::max(
          worst, worstOf(**positions, {std::clamp<std::int64_t>(i, 0, lastColumn),
                                       std::clamp<std::int64_t>(j, 0, lastRow), kSide, kSide}));
    }
    return worst;
  }

 private:
  static constexpr int kSide = 96;
  static constexpr int kTrials = 6;

  static OGRSpatialReference systemOf(const char* text) {
    OGRSpatialReference srs;
    EXPECT_EQ(OGRERR_NONE, srs.SetFromUserInput(text));
    srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return srs;
  }

  static NodeLattice latticeFor(const Case& c, Profile profile, int coarser) {
    constexpr int kCells = 256;
    const Scheme scheme(profile);
    const double degrees = systemOf(c.srs).IsGeographic() ? c.pixel : c.pixel / 111320;
    int zoom = 0;
    while (360.0 / scheme.tilesX(zoom) / kCells > degrees)
      ++zoom;
    return {scheme, std::max(0, zoom - coarser), kCells};
  }

  double worstOf(NodePositions& positions, const NodeRectangle& window) {
    std::vector<double> x(kSide * kSide), y(x);
    const PixelBounds bounds = positions.fill(window, x.data(), y.data());
    double worst = 0;
    for (int k = 0; k < kSide * kSide; ++k) {
      double px = lattice_.longitude(window.i + k % kSide);
      double py = lattice_.latitude(window.j + k / kSide);
      const bool exists = exact_.apply(px, py);
      EXPECT_EQ(exists, !std::isnan(x[std::size_t(k)]));
      if (!exists)
        continue;
      double column = 0;
      double row = 0;
      frame_.toPixel(px, py, column, row);
      const double atX = x[std::size_t(k)];
      const double atY = y[std::size_t(k)];
      worst = std::max({worst, std::abs(atX - column), std::abs(atY - row)});
      EXPECT_TRUE(bounds.west <= atX && atX <= bounds.east);
      EXPECT_TRUE(bounds.north <= atY && atY <= bounds.south);
    }
    return worst;
  }

  Case case_;
  OGRSpatialReference srs_;
  PointTransform exact_;
  NodeLattice lattice_;
  PixelFrame frame_;
};

class Positions : public testing::TestWithParam<std::tuple<Case, Profile, int>> {};

TEST_P(Positions, AreTheExactOnesToAThousandthOfAPixel) {
  const auto& [c, profile, coarser] = GetParam();
  const double worst = PositionsOf(c, profile, coarser).worstError();
  RecordProperty("worstPixels", std::to_string(worst));
  EXPECT_LE(worst, 1.0 / 1024);
}

/// Control cells bend with the square of their size in metres.
TEST(NodePositions, OfMetrePixelsAreMuchNearer) {
  for (const Case& c : kCases) {
    if (c.pixel != 1)
      continue;
    for (const Profile profile : {Profile::geodetic, Profile::mercator})
      EXPECT_LE(PositionsOf(c, profile, 0).worstError(), 2e-5) << c.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Systems, Positions,
                         testing::Combine(testing::ValuesIn(kCases),
                                          testing::Values(Profile::geodetic, Profile::mercator),
                                          testing::Values(0, 3)));

} // namespace
} // namespace qmesh
