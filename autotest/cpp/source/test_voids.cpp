// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Which nodes have a height, and what becomes of a band's numbers.
#include <limits>
#include <random>

#include "made_raster.h"
#include "source/pixel_values.h"

namespace qmesh {
namespace {

/// A lattice whose nodes lie on the corners and centres of pixels: pixels are two nodes wide.
NodeLattice halfPixels() {
  return geodetic(4, 64);
}

/// Pixels of two node spacings, the north-west corner at 0 E, 45 N.
MadeRaster twoNodePixels(int width, int height) {
  MadeRaster made;
  made.width = width;
  made.height = height;
  const double s = 2 * halfPixels().spacingDegrees();
  made.geoTransform = {0, s, 0, 45, 0, -s};
  return made;
}

/// Heights of the nodes of `made` from its north-west corner, row by row southwards, one node more
/// than its rim on each side.
std::vector<float> nodesAround(const SourceOptions& options, const MadeRaster& made) {
  const FactoryPtr factory = openSource(options);
  std::vector<float> out;
  if (!factory)
    return out;
  const auto [i, j] = nodeAt(halfPixels(), 0, 45);
  for (int r = -1; r <= 2 * made.height + 1; ++r)
    for (int c = -1; c <= 2 * made.width + 1; ++c)
      out.push_back(sampleNode(*factory, halfPixels(), i + c, j - r));
  return out;
}

TEST(VoidRule, ANodeIsValidWhereAValidPixelsClosedSquareHoldsIt) {
  // pixels:  1 . 2     nodes lie on their corners, sides and centres
  //          . . .
  //          3 4 .
  MadeRaster made = twoNodePixels(3, 3);
  made.nodata = -9999;
  const double n = NAN;
  const double pixels[3][3] = {{1, n, 2}, {n, n, n}, {3, 4, n}};
  made.value = [&](int c, int r) { return pixels[r][c]; };
  SourceOptions options = optionsFor(write(made));
  for (Resampling resampling :
       {Resampling::nearest, Resampling::bilinear, Resampling::cubic, Resampling::cubicspline,
        Resampling::lanczos, Resampling::average}) {
    options.input.resampling = resampling;
    const std::vector<float> got = nodesAround(options, made);
    ASSERT_EQ(81u, got.size());
    for (int r = -1; r <= 7; ++r)
      for (int c = -1; c <= 7; ++c) {
        // Pixel p holds nodes 2p, 2p+1, 2p+2.
        bool valid = false;
        for (int y = 0; y < 3; ++y)
          for (int x = 0; x < 3; ++x)
            valid |= !std::isnan(pixels[y][x]) && c >= 2 * x && c <= 2 * x + 2 && r >= 2 * y &&
                     r <= 2 * y + 2;
        const float h = got[std::size_t((r + 1) * 9 + c + 1)];
        ASSERT_EQ(valid, h == h) << nameOf(resampling) << " node " << c << "," << r;
        if (valid) {
          ASSERT_TRUE(h > 0 && h < 5) << h; // negative lobes overshoot a little
        }
      }
    EXPECT_EQ(1, got[std::size_t(2 * 9 + 2)]) << "centre of the first pixel";
    EXPECT_EQ(1, got[std::size_t(1 * 9 + 1)]) << "corner of the raster";
    EXPECT_NEAR(resampling == Resampling::nearest ? 4 : 3.5, got[std::size_t(6 * 9 + 3)], 1e-6)
        << "between 3 and 4, voids above";
  }
}

TEST(VoidRule, ReducedNodesNeedHalfOfTheirCell) {
  // A node cell is 4x4 pixels; the west `k` columns of it are valid.
  const NodeLattice lattice = geodetic(4, 8);
  const double pixel = lattice.spacingDegrees() / 4;
  for (int k = 0; k <= 4; ++k) {
    MadeRaster made;
    made.width = made.height = 40;
    made.geoTransform = {0, pixel, 0, 45, 0, -pixel};
    made.nodata = -1;
    // Node 5 of the row is at column 20; its cell is columns 18..21.
    made.value = [&](int c, int) { return c < 18 + k ? 100 : NAN; };
    SourceOptions options = optionsFor(write(made));
    for (Resampling resampling : {Resampling::bilinear, Resampling::cubic, Resampling::cubicspline,
                                  Resampling::lanczos, Resampling::average}) {
      options.input.resampling = resampling;
      const FactoryPtr factory = openSource(options);
      ASSERT_TRUE(factory);
      const auto [i, j] = nodeAt(lattice, 0, 45);
      const float h = sampleNode(*factory, lattice, i + 5, j - 5);
      EXPECT_EQ(k >= 2, h == h) << nameOf(resampling) << " with " << k << " columns";
      if (k >= 2) {
        EXPECT_NEAR(100, h, 1e-4);
      }
      const float corner = sampleNode(*factory, lattice, i, j);
      EXPECT_NEAR(100, corner, 1e-4) << "the raster's corner counts by its own part of the cell";
      EXPECT_TRUE(std::isnan(sampleNode(*factory, lattice, i - 1, j))) << "outside the raster";
    }
  }
}

struct TypeCase {
  GDALDataType type;
  double nodata;
  double plain;
};

class NodataTypes : public testing::TestWithParam<TypeCase> {};

TEST_P(NodataTypes, ComparesInTheBandsOwnType) {
  const TypeCase& c = GetParam();
  MadeRaster made = twoNodePixels(2, 1);
  made.type = c.type;
  made.nodata = c.nodata;
  made.value = [&](int column, int) { return column == 0 ? c.nodata : c.plain; };
  const std::vector<float> got = nodesAround(optionsFor(write(made)), made);
  const std::size_t line = std::size_t(2 * made.width + 3);
  EXPECT_TRUE(std::isnan(got[2 * line + 2])) << got[2 * line + 2];
  EXPECT_FLOAT_EQ(float(c.plain), got[2 * line + 4]);
}

INSTANTIATE_TEST_SUITE_P(
    All, NodataTypes,
    testing::Values(TypeCase{GDT_Float32, -3.4e38, -7}, TypeCase{GDT_Float32, -9999.9, -9998.9},
                    TypeCase{GDT_Float32, 0.1, 0.2}, TypeCase{GDT_Float32, std::nan(""), 5},
                    TypeCase{GDT_Float64, -1.7976931348623157e308, 5},
                    TypeCase{GDT_Float64, 0.1, 0.1000001}, TypeCase{GDT_Int16, -32768, -32767},
                    TypeCase{GDT_UInt16, 65535, 65534}, TypeCase{GDT_Byte, 255, 254},
                    TypeCase{GDT_Int32, -2147483648.0, -2147483647.0},
                    TypeCase{GDT_UInt32, 4294967295.0, 17}));

TEST(Nodata, Int64KeepsItsLastBit) {
  const std::int64_t big = (std::int64_t(1) << 53) + 1;
  MadeRaster made = twoNodePixels(2, 1);
  made.type = GDT_Int64;
  made.finish = [&](GDALDataset& d) {
    GDALRasterBand& band = *d.GetRasterBand(1);
    band.SetNoDataValueAsInt64(big);
    std::int64_t pixels[] = {big, big - 1};
    ASSERT_EQ(CE_None, band.RasterIO(GF_Write, 0, 0, 2, 1, pixels, 2, 1, GDT_Int64, 0, 0, nullptr));
  };
  const std::vector<float> got = nodesAround(optionsFor(write(made)), made);
  EXPECT_TRUE(std::isnan(got[2 * 7 + 2]));
  EXPECT_EQ(float(big - 1), got[2 * 7 + 4]);
}

TEST(Nodata, OptionReplacesTheBandsOwn) {
  MadeRaster made = twoNodePixels(2, 1);
  made.nodata = 7;
  made.value = [](int c, int) { return c == 0 ? 7 : 8; };
  SourceOptions options = optionsFor(write(made));
  options.input.sourceNodata = 8;
  const std::vector<float> got = nodesAround(options, made);
  EXPECT_EQ(7, got[2 * 7 + 2]);
  EXPECT_TRUE(std::isnan(got[2 * 7 + 4]));
}

TEST(Nodata, NanAndInfinityAreVoids) {
  MadeRaster made = twoNodePixels(4, 1);
  const double inf = std::numeric_limits<double>::infinity();
  const double pixels[] = {NAN, inf, -inf, 3};
  made.value = [&](int c, int) { return pixels[c]; };
  const std::vector<float> got = nodesAround(optionsFor(write(made)), made);
  for (int c = 0; c < 3; ++c)
    EXPECT_TRUE(std::isnan(got[std::size_t(2 * 11 + 2 + 2 * c)])) << c;
  EXPECT_EQ(3, got[2 * 11 + 8]);
}

TEST(Masks, MaskBandAndAlphaMakeVoids) {
  for (bool alpha : {false, true}) {
    MadeRaster made = twoNodePixels(2, 1);
    made.type = GDT_Byte;
    made.bands = alpha ? 2 : 1;
    made.value = [](int, int) { return 9; };
    made.finish = [&](GDALDataset& d) {
      if (alpha)
        d.GetRasterBand(2)->SetColorInterpretation(GCI_AlphaBand);
      else
        d.CreateMaskBand(GMF_PER_DATASET);
      GDALRasterBand& mask = alpha ? *d.GetRasterBand(2) : *d.GetRasterBand(1)->GetMaskBand();
      std::uint8_t bytes[] = {0, 255};
      ASSERT_EQ(CE_None, mask.RasterIO(GF_Write, 0, 0, 2, 1, bytes, 2, 1, GDT_Byte, 0, 0, nullptr));
    };
    const std::vector<float> got = nodesAround(optionsFor(write(made)), made);
    EXPECT_TRUE(std::isnan(got[2 * 7 + 2])) << alpha;
    EXPECT_EQ(9, got[2 * 7 + 4]) << alpha;
  }
}

TEST(Values, ScaleOffsetUnitAndSignThenSeaLevelScaleThenClip) {
  MadeRaster made = twoNodePixels(3, 1);
  made.type = GDT_Int16;
  made.nodata = -32768;
  made.value = [](int c, int) { return 10 * (c - 1); }; // -10, 0, 10
  made.finish = [](GDALDataset& d) {
    d.GetRasterBand(1)->SetScale(2);
    d.GetRasterBand(1)->SetOffset(5);
    d.GetRasterBand(1)->SetUnitType("ft");
  };
  SourceOptions options = optionsFor(write(made));
  const auto centres = [&] {
    const std::vector<float> got = nodesAround(options, made);
    return std::array<float, 3>{got[2 * 9 + 2], got[2 * 9 + 4], got[2 * 9 + 6]};
  };
  auto h = centres();
  EXPECT_FLOAT_EQ(-15 * 0.3048f, h[0]);
  EXPECT_FLOAT_EQ(5 * 0.3048f, h[1]);
  EXPECT_FLOAT_EQ(25 * 0.3048f, h[2]);
  options.heights.bathymetry = true;
  h = centres();
  EXPECT_FLOAT_EQ(15 * 0.3048f, h[0]);
  EXPECT_FLOAT_EQ(-25 * 0.3048f, h[2]);
  options.heights.scaleAbove = 10;
  options.heights.scaleBelow = 2;
  options.heights.clipLow = -14;
  options.heights.clipHigh = 40;
  h = centres();
  EXPECT_FLOAT_EQ(40, h[0]) << "45.72 clipped";
  EXPECT_FLOAT_EQ(-3.048f, h[1]);
  EXPECT_FLOAT_EQ(-14, h[2]) << "-15.24 clipped";
}

TEST(Values, UnitsAreKnownByTheirManyNames) {
  for (const char* feet : {"ft", "Feet", "foot", "International foot"})
    EXPECT_EQ(0.3048, *metresPerUnit(feet)) << feet;
  for (const char* feet : {"US survey foot", "us-ft", "ftUS", "US_survey_feet", "foot_us"})
    EXPECT_EQ(1200.0 / 3937.0, *metresPerUnit(feet)) << feet;
  for (const char* metre : {"", "m", "Metre", "meters"})
    EXPECT_EQ(1, *metresPerUnit(metre)) << metre;
  EXPECT_FALSE(metresPerUnit("furlong"));
  EXPECT_FALSE(metresPerUnit("K"));
}

TEST(Values, UnknownUnitAndPaletteWarn) {
  MadeRaster made = twoNodePixels(2, 1);
  made.type = GDT_Byte;
  made.value = [](int c, int) { return 3 + c; };
  made.finish = [](GDALDataset& d) {
    GDALColorTable table;
    const GDALColorEntry grey{100, 100, 100, 255};
    table.SetColorEntry(3, &grey);
    d.GetRasterBand(1)->SetColorTable(&table);
    d.GetRasterBand(1)->SetUnitType("furlong");
  };
  std::vector<std::string> warnings;
  const std::string path = write(made);
  ASSERT_TRUE(openSource(optionsFor(path), &warnings));
  ASSERT_EQ(2u, warnings.size());
  EXPECT_NE(std::string::npos, warnings[0].find("furlong"));
  EXPECT_NE(std::string::npos, warnings[1].find("palette"));
  EXPECT_EQ(4, nodesAround(optionsFor(path), made)[2 * 7 + 4]);
}

TEST(HasData, TellsAllVoidFromOneHeight) {
  for (bool one : {false, true}) {
    MadeRaster made = twoNodePixels(1500, 1100);
    made.nodata = -1;
    made.value = [&](int c, int r) { return one && c == 1499 && r == 1099 ? 5 : NAN; };
    const FactoryPtr factory = openSource(optionsFor(write(made)));
    ASSERT_TRUE(factory);
    EXPECT_EQ(one, *factory->hasData());
  }
}

} // namespace
} // namespace qmesh
