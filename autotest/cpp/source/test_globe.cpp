// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Round the globe: antimeridian, poles, longitudes of 0..360.
#include <random>

#include "made_raster.h"
#include "source/pixel_frame.h"

namespace qmesh {
namespace {

/// A smooth surface on the globe, the same at -180 and +180.
double surface(double lon, double lat) {
  const double rad = std::acos(-1.0) / 180;
  return 1000 * std::sin(lat * rad) + 500 * std::cos(lat * rad) * std::cos((lon - 30) * rad) +
         100 * std::sin(6 * lon * rad);
}

MadeRaster globe(double west, int columns, int rows, double extraColumns = 0) {
  MadeRaster made;
  const double d = 360.0 / columns;
  made.width = columns + int(extraColumns);
  made.height = rows;
  made.geoTransform = {west, d, 0, 90, 0, -180.0 / rows};
  made.value = [made](int c, int r) {
    const auto p = made.centre(c, r);
    return surface(p[0], p[1]);
  };
  return made;
}

TEST(Globe, WrapsAtTheAntimeridianWhereverItBegins) {
  for (double west : {-180.0, 0.0, -20.0, 170.5}) {
    const FactoryPtr factory = openSource(optionsFor(write(globe(west, 1440, 720))));
    ASSERT_TRUE(factory);
    ASSERT_EQ(1u, factory->extent().size());
    EXPECT_EQ(-180, factory->extent()[0].west);
    EXPECT_EQ(180, factory->extent()[0].east);
    EXPECT_EQ(-90, factory->extent()[0].south);
    EXPECT_EQ(90, factory->extent()[0].north);
    const NodeLattice lattice = geodetic(3, 64);
    const std::int64_t columns = lattice.columns();
    for (std::int64_t j : {0, 5, 100, 256, 400, 511, 512}) {
      const auto row = sampleNodes(*factory, lattice, -3, j, int(columns) + 6, 1);
      for (int a = 0; a < int(row.size()); ++a) {
        ASSERT_NEAR(surface(lattice.longitude(a - 3), lattice.latitude(j)), row[std::size_t(a)], 2)
            << "west " << west << " node " << a - 3 << "," << j;
        if (a >= int(columns)) {
          ASSERT_EQ(row[std::size_t(a - int(columns))], row[std::size_t(a)]);
        }
      }
    }
  }
}

/// A value of its own for each pixel: the mean across the seam shows which columns were joined.
TEST(Globe, InterpolatesAcrossTheSeam) {
  for (Resampling resampling : {Resampling::bilinear, Resampling::cubic, Resampling::lanczos}) {
    MadeRaster made = globe(-180, 8, 4);
    made.value = [](int c, int) { return c == 0 ? 300 : c == 7 ? 100 : 0; };
    SourceOptions options = optionsFor(write(made));
    options.input.resampling = resampling;
    const FactoryPtr factory = openSource(options);
    ASSERT_TRUE(factory);
    const float seam = sampleNode(*factory, geodetic(0, 8), 0, 4);
    if (resampling == Resampling::bilinear) {
      EXPECT_EQ(200, seam);
    } else {
      EXPECT_GT(seam, 200) << "lobes beyond fall on zeros";
    }
    EXPECT_EQ(seam, sampleNode(*factory, geodetic(0, 8), 16, 4));
  }
}

TEST(Globe, ADuplicateColumnIsTheSameMeridian) {
  // Grid-registered: column centres at -180, ..., +180.
  MadeRaster made = globe(-180 - 0.125, 1440, 720, 1);
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  const NodeLattice lattice = geodetic(3, 64);
  for (std::int64_t i : {0, 1, 1022, 1023})
    EXPECT_NEAR(surface(lattice.longitude(i), lattice.latitude(200)),
                sampleNode(*factory, lattice, i, 200), 1);
}

TEST(Globe, PoleHeightIsTheMeanOfItsRow) {
  MadeRaster made = globe(-180, 360, 180);
  made.value = [](int c, int r) { return r == 0 ? c : r == 179 ? -c : 0; };
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  EXPECT_NEAR(179.5, factory->poleHeight(true), 0.5);
  EXPECT_NEAR(-179.5, factory->poleHeight(false), 0.5);
}

TEST(Globe, NoPoleNoHeight) {
  MadeRaster made;
  made.geoTransform = {10, 0.1, 0, 50, 0, -0.1};
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  EXPECT_TRUE(std::isnan(factory->poleHeight(true)));
  EXPECT_TRUE(std::isnan(factory->poleHeight(false)));
}

TEST(Globe, PolarStereographicHoldsThePole) {
  MadeRaster made;
  made.width = made.height = 101;
  made.srs = "EPSG:3031";
  made.geoTransform = {-505000, 10000, 0, 505000, 0, -10000};
  made.value = [](int c, int r) { return c == 50 && r == 50 ? 2835 : 2800; };
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  EXPECT_NEAR(2835, factory->poleHeight(false), 0.1);
  EXPECT_TRUE(std::isnan(factory->poleHeight(true)));
  const GeoBox box = factory->extent()[0];
  EXPECT_EQ(-90, box.south);
  EXPECT_NEAR(-83.5, box.north, 0.3);
  EXPECT_EQ(360, box.east - box.west);
  // All of the parallel at 88 S has data, the whole way round.
  const NodeLattice lattice = geodetic(4, 64);
  const auto j = nodeAt(lattice, 0, -88)[1];
  for (float h : sampleNodes(*factory, lattice, 0, j, int(lattice.columns()), 1))
    ASSERT_NEAR(2800, h, 1e-3);
}

TEST(Globe, CrossesTheAntimeridianInUtm) {
  MadeRaster made; // zone 60 and a little beyond
  made.width = 400;
  made.height = 100;
  made.srs = "EPSG:32660";
  made.geoTransform = {600000, 1000, 0, 6650000, 0, -1000};
  made.value = [](int, int) { return 42; };
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  const GeoBox box = factory->extent()[0];
  EXPECT_GT(box.west, 178);
  EXPECT_LT(box.west, 180);
  EXPECT_GT(box.east, 184);
  EXPECT_LT(box.east, 188);
  const NodeLattice lattice = geodetic(6, 64);
  const auto j = nodeAt(lattice, 180, 59.5)[1];
  for (std::int64_t i = -10; i <= 10; ++i)
    EXPECT_EQ(42, sampleNode(*factory, lattice, i, j)) << i;
}

TEST(Globe, OtherDatumsGoRoundToo) {
  MadeRaster made = globe(0, 720, 360);
  made.srs = "EPSG:4258";
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  EXPECT_EQ(360, factory->extent()[0].east - factory->extent()[0].west);
  const NodeLattice lattice = geodetic(2, 64);
  for (std::int64_t j : {3, 128, 250})
    for (std::int64_t i = 0; i < lattice.columns(); ++i)
      ASSERT_NEAR(surface(lattice.longitude(i), lattice.latitude(j)),
                  sampleNode(*factory, lattice, i, j), 5);
}

TEST(Globe, MercatorProfileAndWorldMercatorSource) {
  MadeRaster made;
  made.width = made.height = 512;
  made.srs = "EPSG:3857";
  const double half = 20037508.342789244;
  made.geoTransform = {-half, half / 256, 0, half, 0, -half / 256};
  made.value = [](int c, int r) { return 10 * r + c; };
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  EXPECT_NEAR(360, factory->extent()[0].east - factory->extent()[0].west, 1e-6);
  EXPECT_NEAR(85.0511287798, factory->extent()[0].north, 1e-6);
  const NodeLattice lattice = mercator(1, 256); // one node a pixel corner
  EXPECT_EQ(1, factory->nativeZoom(Scheme(Profile::mercator), 256));
  for (int k = 1; k < 512; k += 37)
    for (int r = 1; r < 512; r += 41)
      EXPECT_NEAR(10 * (r - 0.5) + k - 0.5, sampleNode(*factory, lattice, k, 512 - r), 0.02);
}

TEST(PixelFrame, UnwrapsToTheRastersMiddle) {
  PixelFrame frame;
  ASSERT_TRUE(frame.set({0, 1, 0, 90, 0, -1}, 360, 180, 360));
  EXPECT_EQ(360, frame.period);
  double column = 0, row = 0;
  frame.toPixel(-1, 0, column, row);
  EXPECT_EQ(359, column);
  EXPECT_EQ(90, row);
  ASSERT_TRUE(frame.set({170, 0.1, 0, 10, 0, -0.1}, 200, 100, 360));
  EXPECT_EQ(0, frame.period);
  frame.toPixel(-175, 5, column, row);
  EXPECT_NEAR(150, column, 1e-9);
  EXPECT_FALSE(frame.set({0, 1, 1, 0, 1, 1}, 10, 10, 0)) << "no area";
}

// East of 180 degrees a cylindrical raster goes on beyond the world's width; PROJ knows only the
// place on its west side.
TEST(Globe, CylindricalRastersCrossTheAntimeridian) {
  constexpr double kHalf = 20037508.342789244;
  for (const char* srs : {"EPSG:3857", "EPSG:3395", "EPSG:4087"}) {
    SCOPED_TRACE(srs);
    MadeRaster made;
    made.width = made.height = 200;
    made.srs = srs;
    made.geoTransform = {kHalf - 1e6, 1e4, 0, 1e6, 0, -1e4};
    made.value = [](int c, int r) { return 1000 + 3 * c + 2 * r; };
    const FactoryPtr factory = openSource(optionsFor(write(made)));
    ASSERT_TRUE(factory);
    const NodeLattice lattice = geodetic(6, 64);
    for (const double lon : {-175.0, -179.0, 180.0, 179.0, 175.0}) {
      const auto [i, j] = nodeAt(lattice, lon, 0);
      const double x = lattice.longitude(i) / 180 * kHalf;
      const double column = ((x < 0 ? x + 2 * kHalf : x) - (kHalf - 1e6)) / 1e4 - 0.5;
      EXPECT_NEAR(sampleNode(*factory, lattice, i, j), 1000 + 3 * column + 2 * 99.5, 0.01) << lon;
    }
  }
}

} // namespace
} // namespace qmesh
