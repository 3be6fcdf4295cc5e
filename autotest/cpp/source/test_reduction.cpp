// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Nodes further apart than pixels: block means, overviews, kernels against brute force.
#include <random>

#include "made_raster.h"
#include "source/interpolator.h"
#include "source/pixel_level.h"
#include "source/pixel_reader.h"

namespace qmesh {
namespace {

struct Opened {
  explicit Opened(const std::string& path)
      : dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER)), band(dataset->GetRasterBand(1)) {
    std::array<double, 6> transform{};
    dataset->GetGeoTransform(transform.data());
    EXPECT_TRUE(frame.set(transform, dataset->GetRasterXSize(), dataset->GetRasterYSize(), 0));
    std::vector<std::string> warnings;
    input.path = path;
    input.values = PixelValues::of(*band, std::nullopt, false, warnings);
  }
  GDALDatasetUniquePtr dataset;
  GDALRasterBand* band;
  PixelFrame frame;
  RasterInput input;
};

TEST(BlockMeans, EqualBruteForceAtAnyWindow) {
  std::mt19937 random(31);
  MadeRaster made;
  made.width = 517;
  made.height = 389;
  made.nodata = -1;
  std::vector<double> pixels(std::size_t(made.width * made.height));
  for (double& p : pixels)
    p = random() % 5 < 2 ? NAN : double(random() % 3000);
  made.value = [&](int c, int r) { return pixels[std::size_t(r * made.width + c)]; };
  const Opened raster(write(made));
  for (const auto& [bx, by] : {std::pair{2, 2}, {8, 4}, {64, 16}, {1, 32}, {1024, 1024}}) {
    PixelLevel level = PixelLevel::full(raster.frame);
    level.blockX = bx;
    level.blockY = by;
    PixelReader reader(*raster.band, raster.input, level, 0);
    for (int trial = 0; trial < 20; ++trial) {
      PixelWindow w;
      w.column = int(random() % unsigned(level.columns()));
      w.row = int(random() % unsigned(level.rows()));
      w.width = 1 + int(random() % unsigned(level.columns() - w.column));
      w.height = 1 + int(random() % unsigned(level.rows() - w.row));
      ASSERT_TRUE(reader.read(w).ok());
      for (int k = 0; k < w.width * w.height; ++k) {
        const int column = w.column + k % w.width;
        const int row = w.row + k / w.width;
        double sum = 0;
        int valid = 0, all = 0;
        for (int r = row * by; r < std::min(made.height, (row + 1) * by); ++r)
          for (int c = column * bx; c < std::min(made.width, (column + 1) * bx); ++c, ++all)
            if (const double p = made.value(c, r); p == p) {
              sum += p;
              ++valid;
            }
        const float got = w.data[std::size_t(k)];
        ASSERT_EQ(2 * valid >= all, got == got) << column << "," << row;
        if (got == got) {
          ASSERT_EQ(float(sum / valid), got);
        }
      }
    }
  }
}

TEST(PixelLevel, ChoosesOverviewAndBlocksOnceByTheScale) {
  MadeRaster made;
  made.width = 1001;
  made.height = 901;
  made.finish = [](GDALDataset& d) {
    int factors[] = {2, 4, 8, 16};
    ASSERT_EQ(CE_None, d.BuildOverviews("AVERAGE", 4, factors, 0, nullptr, nullptr, nullptr));
  };
  const Opened raster(write(made));
  const auto choose = [&](double x, double y) {
    return PixelLevel::choose(*raster.band, raster.frame, x, y);
  };
  EXPECT_EQ(-1, choose(7.9, 7.9).overview);
  EXPECT_EQ(1, choose(7.9, 7.9).blockX);
  const PixelLevel eight = choose(9, 9);
  EXPECT_EQ(1, eight.overview) << "four pixels a cell, 2.25 left";
  EXPECT_EQ(251, eight.columns());
  EXPECT_DOUBLE_EQ(1001.0 / 251, eight.factorX);
  EXPECT_DOUBLE_EQ(901.0 / 226, eight.factorY);
  const PixelLevel far = choose(1000, 300);
  EXPECT_EQ(3, far.overview);
  EXPECT_EQ(8, far.blockX) << "1000 / 15.9 / 8 is below 8";
  EXPECT_EQ(4, far.blockY);
}

TEST(PixelLevel, BlocksDivideTheTurnOfAGlobe) {
  MadeRaster made;
  made.width = 1080; // 8 * 135
  made.height = 540;
  const Opened raster(write(made));
  PixelFrame frame = raster.frame;
  ASSERT_TRUE(frame.set({-180, 1.0 / 3, 0, 90, 0, -1.0 / 3}, 1080, 540, 360));
  const PixelLevel level = PixelLevel::choose(*raster.band, frame, 135, 135);
  EXPECT_EQ(8, level.blockX);
  EXPECT_EQ(32, level.blockY);
  EXPECT_EQ(135, frame.reduced(level.factorX, level.factorY).period);
}

void use(Interpolator& interpolator, const PixelWindow& window, double x, double y) {
  PixelBounds bounds;
  bounds.add(x, y);
  interpolator.use(window, bounds);
}

/// The stretched kernels on a raster of noise, against their textbook formulas written out again.
TEST(Interpolator, EqualsTheDefinition) {
  std::mt19937 random(99);
  MadeRaster made;
  made.width = made.height = 90;
  PixelFrame frame;
  ASSERT_TRUE(frame.set({0, 1, 0, 0, 0, 1}, 90, 90, 0));
  PixelWindow window;
  window.width = window.height = 90;
  window.data.resize(90 * 90);
  for (float& p : window.data)
    p = float(random() % 1000);
  const auto sinc = [](double x) {
    const double a = std::acos(-1.0) * x;
    return std::abs(a) < 1e-12 ? 1 : std::sin(a) / a;
  };
  const auto formula = [&](Resampling r, double t) -> double {
    t = std::abs(t);
    switch (r) {
    case Resampling::bilinear:
      return std::max(0.0, 1 - t);
    case Resampling::cubic:
      return t < 1   ? 1.5 * t * t * t - 2.5 * t * t + 1
             : t < 2 ? -0.5 * t * t * t + 2.5 * t * t - 4 * t + 2
                     : 0;
    case Resampling::cubicspline:
      return t < 1 ? (3 * t * t * t - 6 * t * t + 4) / 6 : t < 2 ? std::pow(2 - t, 3) / 6 : 0;
    default:
      return t < 3 ? sinc(t) * sinc(t / 3) : 0;
    }
  };
  for (Resampling r :
       {Resampling::bilinear, Resampling::cubic, Resampling::cubicspline, Resampling::lanczos})
    for (const double scale : {1.0, 2.0, 4.0}) {
      Interpolator interpolator(r, scale, scale, frame);
      for (int trial = 0; trial < 50; ++trial) {
        // On pixel centres: there the centre of gravity needs no correction.
        const int cx = 30 + int(random() % 30), cy = 30 + int(random() % 30);
        const double x = cx + 0.5, y = cy + 0.5;
        double sum = 0, total = 0;
        for (int v = 0; v < 90; ++v)
          for (int u = 0; u < 90; ++u) {
            const double w = formula(r, (u - cx) / scale) * formula(r, (v - cy) / scale);
            sum += w * window.at(u, v);
            total += w;
          }
        float got = 0;
        use(interpolator, window, x, y);
        interpolator.run(&x, &y, 1, &got);
        ASSERT_NEAR(sum / total, got, 2e-3) << nameOf(r) << " scale " << scale;
      }
    }
}

TEST(Interpolator, AverageIsTheMeanOfTheCellsBox) {
  PixelFrame frame;
  ASSERT_TRUE(frame.set({0, 1, 0, 0, 0, 1}, 8, 8, 0));
  PixelWindow window;
  window.width = window.height = 8;
  for (int k = 0; k < 64; ++k)
    window.data.push_back(float(k % 8 < 4 ? 0 : 8));
  Interpolator interpolator(Resampling::average, 2.5, 2, frame);
  const double x = 4, y = 4;
  float got = 0;
  use(interpolator, window, x, y);
  interpolator.run(&x, &y, 1, &got);
  EXPECT_FLOAT_EQ(4, got);
  const double x2 = 4.75;
  use(interpolator, window, x2, y);
  interpolator.run(&x2, &y, 1, &got);
  EXPECT_FLOAT_EQ(8 * 2.0f / 2.5f, got);
}

TEST(Reduction, AMeanOfNoiseStaysNearTheMean) {
  // 100 pixels a node, with overviews and without: the same surface but for the noise.
  std::mt19937 random(5);
  for (bool overviews : {false, true}) {
    MadeRaster made;
    made.width = made.height = 2000;
    const NodeLattice lattice = geodetic(2, 64);
    const double d = lattice.spacingDegrees() / 100;
    made.geoTransform = {10, d, 0, 50, 0, -d};
    made.value = [&](int c, int r) { return c + 2 * r + double(random() % 200) - 99.5; };
    if (overviews)
      made.finish = [](GDALDataset& dataset) {
        int factors[] = {2, 4, 8, 16};
        dataset.BuildOverviews("AVERAGE", 4, factors, 0, nullptr, nullptr, nullptr);
      };
    const FactoryPtr factory = openSource(optionsFor(write(made)));
    ASSERT_TRUE(factory);
    const auto [i, j] = nodeAt(lattice, 10, 50);
    for (int b = 2; b < 18; ++b)
      for (int a = 2; a < 18; ++a) {
        const double column = (lattice.longitude(i + a) - 10) / d - 0.5;
        const double row = (50 - lattice.latitude(j - b)) / d - 0.5;
        ASSERT_NEAR(column + 2 * row, sampleNode(*factory, lattice, i + a, j - b), 4)
            << a << "," << b;
      }
  }
}

} // namespace
} // namespace qmesh
