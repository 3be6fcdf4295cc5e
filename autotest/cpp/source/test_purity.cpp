// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// A node's height is a pure function of its position: any partition of a window gives the same
// bits.
#include <cstring>
#include <random>

#include "made_raster.h"

namespace qmesh {
namespace {

struct Case {
  const char* name;
  const char* srs;
  std::array<double, 6> geoTransform;
  double lon, lat; ///< a place in its middle
  int zoom;        ///< of a lattice with 64 cells a tile, about as fine as the pixels
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

constexpr int kSize = 150;

const Case kCases[] = {
    {"utm", "EPSG:32611", {376313.7, 30, 0, 3807917.8, 0, -30}, -118.32, 34.38, 13},
    {"nad27", "EPSG:26710", {557805, 30, 0, 5122005, 0, -30}, -122.22, 46.23, 13},
    {"polar", "EPSG:3031", {-75000, 1000, 0, 75000, 0, -1000}, 10, -89.7, 8},
    {"polarOffset", "EPSG:3413", {-75000, 1000, 0, -525000, 0, -1000}, -45, 84.5, 8},
    {"degrees360", "EPSG:4326", {0, 2.4, 0, 90, 0, -1.2}, 175, 3, 1},
    {"rotated", "EPSG:32633", {500000, 21, 21, 5100000, 21, -21}, 15.03, 46.04, 13},
    {"rotatedDegrees", "EPSG:4326", {10, 0.001, 0.0005, 50, 0.0004, -0.001}, 10.1, 49.95, 12},
    {"etrs89", "EPSG:4258", {10, 0.001, 0, 50, 0, -0.001}, 10.07, 49.93, 12},
    {"southUp", "EPSG:32633", {500000, 30, 0, 5100000, 0, 30}, 15.03, 46.07, 13},
    {"worldMercator", "EPSG:3857", {-20037508.34, 267166.8, 0, 20037508.34, 0, -267166.8}, 0, 0, 1},
};

class Purity : public testing::TestWithParam<std::tuple<Case, Resampling, int>> {};

TEST_P(Purity, AnyPartitionGivesTheSameBits) {
  const auto& [c, resampling, coarser] = GetParam();
  std::mt19937 random(20260211);
  std::uniform_real_distribution<double> height(-500, 3000);
  MadeRaster made;
  made.width = made.height = kSize;
  made.geoTransform = c.geoTransform;
  made.srs = c.srs;
  made.nodata = -9999;
  made.value = [&](int, int) { return random() % 50 == 0 ? NAN : height(random); };
  SourceOptions options = optionsFor(write(made));
  options.input.resampling = resampling;
  const FactoryPtr factory = openSource(options);
  ASSERT_TRUE(factory);
  const NodeLattice lattice = geodetic(std::max(0, c.zoom - coarser), 64);

  const int width = 203;
  const int rows = int(std::min<std::int64_t>(171, lattice.lastRow() + 1));
  const auto [i, j] = nodeAt(lattice, c.lon, c.lat);
  const std::int64_t i0 = i - width / 2;
  const std::int64_t j0 = std::clamp<std::int64_t>(j - rows / 2, 0, lattice.lastRow() + 1 - rows);
  const std::vector<float> whole = sampleNodes(*factory, lattice, i0, j0, width, rows);
  int valid = 0;
  for (float h : whole)
    valid += h == h;
  EXPECT_GT(valid, 10);

  const auto source = factory->open(lattice);
  ASSERT_TRUE(source.ok());
  for (int trial = 0; trial < 60; ++trial) {
    const int w = 1 + int(random() % (trial % 2 ? 5 : width));
    const int h = 1 + int(random() % (trial % 3 ? 5 : unsigned(rows)));
    const int a = int(random() % unsigned(width - w + 1));
    const int b = int(random() % unsigned(rows - h + 1));
    const std::int64_t turn = (std::int64_t(trial % 3) - 1) * lattice.columns();
    std::vector<float> part(std::size_t(w) * std::size_t(h));
    ASSERT_TRUE((*source)->sample(i0 + a + turn, j0 + b, w, h, part.data(), w).ok());
    for (int r = 0; r < h; ++r)
      ASSERT_EQ(0, std::memcmp(&part[std::size_t(r * w)], &whole[std::size_t((b + r) * width + a)],
                               std::size_t(w) * sizeof(float)))
          << "window " << w << "x" << h << " at " << a << "," << b << ", row " << r;
  }
}

std::string nameOfCase(const testing::TestParamInfo<Purity::ParamType>& c) {
  return std::string(std::get<0>(c.param).name) + "_" + nameOf(std::get<1>(c.param)) +
         (std::get<2>(c.param) < 0 ? "_finer" : "_coarser" + std::to_string(std::get<2>(c.param)));
}

INSTANTIATE_TEST_SUITE_P(All, Purity,
                         testing::Combine(testing::ValuesIn(kCases),
                                          testing::Values(Resampling::nearest, Resampling::bilinear,
                                                          Resampling::cubic,
                                                          Resampling::cubicspline,
                                                          Resampling::lanczos, Resampling::average),
                                          testing::Values(-3, 0, 2, 4)),
                         nameOfCase);

} // namespace
} // namespace qmesh
