// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Where the data is, the native zoom, --te and --cutline.
#include <random>

#include <ogrsf_frmts.h>

#include "made_raster.h"

namespace qmesh {
namespace {

MadeRaster degreeRaster(double west, double north, int size, double degrees) {
  MadeRaster made;
  made.width = made.height = size;
  made.geoTransform = {west, degrees / size, 0, north, 0, -degrees / size};
  made.value = [](int c, int r) { return 1000 + c + r; };
  return made;
}

TEST(Extent, GeographicIsExactAndSnapsToRoundPlaces) {
  MadeRaster made = degreeRaster(9, 48, 1200, 1);
  made.geoTransform[1] = 0.000833333333; // as text files have it
  made.geoTransform[5] = -0.000833333333;
  FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  EXPECT_EQ(9, factory->extent()[0].west);
  EXPECT_EQ(10, factory->extent()[0].east);
  EXPECT_EQ(47, factory->extent()[0].south);
  EXPECT_EQ(48, factory->extent()[0].north);
  factory = openSource(optionsFor(write(degreeRaster(11.25, 45, 512, 5.625))));
  EXPECT_EQ(11.25, factory->extent()[0].west);
  EXPECT_EQ(16.875, factory->extent()[0].east);
  EXPECT_EQ(39.375, factory->extent()[0].south);
}

/// A sparse GeoTIFF of 100 x 50 degrees with two blocks written: at 0..5 E and 90..95 E, 45..50 N.
std::string sparseRaster(const std::string& name, bool withNodata) {
  GDALAllRegister();
  const std::string path = "/vsimem/gdalio/" + name;
  const char* const options[] = {"TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256", "SPARSE_OK=TRUE",
                                 nullptr};
  GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      path.c_str(), 5120, 2560, 1, GDT_Float32, const_cast<char**>(options));
  double transform[6] = {0, 5.0 / 256, 0, 50, 0, -5.0 / 256};
  dataset->SetGeoTransform(transform);
  OGRSpatialReference srs;
  srs.SetFromUserInput("EPSG:4326");
  dataset->SetSpatialRef(&srs);
  if (withNodata)
    dataset->GetRasterBand(1)->SetNoDataValue(-9999);
  std::vector<float> block(256 * 256, 7);
  for (const int column : {0, 18 * 256}) {
    EXPECT_EQ(CE_None,
              dataset->GetRasterBand(1)->RasterIO(GF_Write, column, 0, 256, 256, block.data(), 256,
                                                  256, GDT_Float32, 0, 0, nullptr));
  }
  GDALClose(dataset);
  return path;
}

// P4: what a file knows to be empty costs nothing - where empty means void, and not 0 metres.
TEST(Extent, LeavesOutTheHolesOfASparseRaster) {
  const FactoryPtr sparse = openSource(optionsFor(sparseRaster("sparse.tif", true)));
  ASSERT_TRUE(sparse);
  constexpr double kSlack = 64 * 5.0 / 256; // degrees: holes are told by 64 pixels
  bool west = false, east = false;
  for (const GeoBox& box : sparse->extent()) {
    EXPECT_TRUE(box.east <= 5 + kSlack || (box.west >= 90 - kSlack && box.east <= 95 + kSlack))
        << box.west << " " << box.east;
    EXPECT_GE(box.south, 45 - kSlack);
    west = west || (box.west <= 2 && box.east >= 2);
    east = east || (box.west <= 92 && box.east >= 92);
  }
  EXPECT_TRUE(west && east);

  const FactoryPtr zeros = openSource(optionsFor(sparseRaster("zeros.tif", false)));
  ASSERT_TRUE(zeros);
  ASSERT_EQ(1u, zeros->extent().size());
  EXPECT_EQ(100, zeros->extent()[0].east);
}

TEST(Extent, EastLongitudesAreBroughtHome) {
  const FactoryPtr factory = openSource(optionsFor(write(degreeRaster(350, 10, 100, 20))));
  ASSERT_TRUE(factory);
  EXPECT_EQ(-10, factory->extent()[0].west);
  EXPECT_EQ(10, factory->extent()[0].east);
  const NodeLattice lattice = geodetic(4, 64);
  const auto [i, j] = nodeAt(lattice, 5, 0);
  EXPECT_NEAR(1000 + 74.5 + 49.5, sampleNode(*factory, lattice, i, j), 1.1);
}

TEST(Extent, ProjectedBoxHoldsEveryPixelTightly) {
  MadeRaster made;
  made.width = 1197;
  made.height = 643;
  made.srs = "EPSG:32611";
  made.geoTransform = {376313.6555, 30, 0, 3807917.828, 0, -30};
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  OGRSpatialReference utm, lonLat;
  utm.importFromEPSG(32611);
  lonLat.importFromEPSG(4326);
  utm.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  lonLat.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  std::unique_ptr<OGRCoordinateTransformation> t(OGRCreateCoordinateTransformation(&utm, &lonLat));
  GeoBox want{1e9, 1e9, -1e9, -1e9};
  for (int r = 0; r <= 643; ++r)
    for (int c = 0; c <= 1197; c += r % 643 ? 1197 : 1) {
      double x = 376313.6555 + 30 * c, y = 3807917.828 - 30 * r;
      t->Transform(1, &x, &y);
      want = {std::min(want.west, x), std::min(want.south, y), std::max(want.east, x),
              std::max(want.north, y)};
    }
  const GeoBox got = factory->extent()[0];
  EXPECT_NEAR(want.west, got.west, 1e-7);
  EXPECT_NEAR(want.south, got.south, 1e-7);
  EXPECT_NEAR(want.east, got.east, 1e-7);
  EXPECT_NEAR(want.north, got.north, 1e-7);
  EXPECT_EQ(12, factory->nativeZoom(Scheme(Profile::geodetic), 256));
}

TEST(NativeZoom, FirstThatIsNotCoarserThanTheCell) {
  const Scheme geodeticScheme(Profile::geodetic);
  // 180 / (256 * 2^z) <= 3 arc seconds for the first time at z = 10.
  EXPECT_EQ(
      10,
      openSource(optionsFor(write(degreeRaster(9, 48, 1200, 1))))->nativeZoom(geodeticScheme, 256));
  EXPECT_EQ(
      12,
      openSource(optionsFor(write(degreeRaster(9, 48, 1200, 1))))->nativeZoom(geodeticScheme, 64));
  // Exactly the spacing of zoom 5: zoom 5, not 6.
  EXPECT_EQ(5, openSource(optionsFor(write(degreeRaster(11.25, 45, 256, 5.625))))
                   ->nativeZoom(geodeticScheme, 256));
  MadeRaster flat = degreeRaster(11.25, 45, 256, 5.625);
  flat.geoTransform[5] /= 4; // the smaller side counts
  EXPECT_EQ(7, openSource(optionsFor(write(flat)))->nativeZoom(geodeticScheme, 256));
}

int validNodes(const NodeSourceFactory& factory, const NodeLattice& lattice, const GeoBox& box) {
  const auto [i0, j0] = nodeAt(lattice, box.west, box.south);
  const auto [i1, j1] = nodeAt(lattice, box.east, box.north);
  int valid = 0;
  for (float h : sampleNodes(factory, lattice, i0, j0, int(i1 - i0) + 1, int(j1 - j0) + 1))
    valid += h == h;
  return valid;
}

TEST(TargetExtent, CropsToAClosedBox) {
  SourceOptions options = optionsFor(write(degreeRaster(0, 20, 200, 20)));
  options.input.extent = {{5.625, 5.625, 11.25, 11.25}};
  const FactoryPtr factory = openSource(options);
  ASSERT_TRUE(factory);
  ASSERT_EQ(1u, factory->extent().size());
  EXPECT_EQ(5.625, factory->extent()[0].west);
  EXPECT_EQ(11.25, factory->extent()[0].north);
  const NodeLattice lattice = geodetic(5, 64);
  EXPECT_EQ(65 * 65, validNodes(*factory, lattice, {0, 0, 20, 20})) << "both rims count";
}

TEST(TargetExtent, InAnotherSystemAndAcrossTheAntimeridian) {
  SourceOptions options = optionsFor(write(degreeRaster(170, 10, 200, 20)));
  options.input.extent = {{175, -5, 185, 5}};
  FactoryPtr factory = openSource(options);
  ASSERT_TRUE(factory);
  const NodeLattice lattice = geodetic(5, 64);
  const auto j = nodeAt(lattice, 0, 0)[1];
  const auto at = [&](double lon) {
    return sampleNode(*factory, lattice, nodeAt(lattice, lon, 0)[0], j);
  };
  EXPECT_TRUE(at(174.9) != at(174.9));
  EXPECT_TRUE(at(175.1) == at(175.1));
  EXPECT_TRUE(at(-175.1) == at(-175.1));
  EXPECT_TRUE(at(-174.9) != at(-174.9));

  options.input.extentSrs = "EPSG:32660"; // 500 km round 177 E on the equator
  options.input.extent = {{250000, 10000, 750000, 400000}};
  factory = openSource(options);
  ASSERT_TRUE(factory);
  EXPECT_NEAR(174.75, factory->extent()[0].west, 0.02);
  EXPECT_NEAR(179.25, factory->extent()[0].east, 0.02);
}

TEST(TargetExtent, ThatMissesOrIsEmptyIsAnError) {
  SourceOptions options = optionsFor(write(degreeRaster(0, 20, 200, 20)));
  std::vector<std::string> warnings;
  options.input.extent = {{50, 0, 60, 10}};
  EXPECT_EQ(Code::input,
            openRasterSource(options.input, options.heights, warnings).status().code());
  options.input.extent = {{10, 0, 5, 10}};
  EXPECT_EQ(Code::usage,
            openRasterSource(options.input, options.heights, warnings).status().code());
  options.input.extent = {{0, 0, 5, 10}};
  options.input.extentSrs = "EPSG:nothing";
  EXPECT_EQ(Code::usage,
            openRasterSource(options.input, options.heights, warnings).status().code());
}

std::string writeText(const std::string& name, const std::string& text) {
  const std::string path = "/vsimem/gdalio/" + name;
  VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
  VSIFWriteL(text.data(), 1, text.size(), file);
  VSIFCloseL(file);
  return path;
}

std::string geoJson(const std::string& geometry, const std::string& crs = "") {
  return R"({"type":"FeatureCollection",)" +
         (crs.empty() ? "" : R"("crs":{"type":"name","properties":{"name":")" + crs + R"("}},)") +
         R"("features":[{"type":"Feature","properties":{},"geometry":)" + geometry + "}]}";
}

TEST(Cutline, EqualsPointInPolygon) {
  // A star with a hole, and a second polygon: GEOS or OGR say which node is inside.
  std::mt19937 random(77);
  std::string star, hole;
  OGRPolygon polygon;
  OGRLinearRing outer, inner;
  const double turn = 2 * std::acos(-1.0);
  for (int k = 0; k <= 40; ++k) {
    const double angle = turn * (k % 40) / 40;
    const double radius = k % 40 % 2 ? 3 : 8;
    const double x = 10 + radius * std::cos(angle), y = 10 + radius * std::sin(angle);
    outer.addPoint(x, y);
    inner.addPoint(10 + std::cos(angle), 10 + std::sin(angle));
  }
  polygon.addRing(&outer);
  polygon.addRing(&inner);
  char* text = polygon.exportToJson();
  SourceOptions options = optionsFor(write(degreeRaster(0, 20, 200, 20)));
  options.input.cutline = writeText("cut.geojson", geoJson(text));
  CPLFree(text);
  const FactoryPtr factory = openSource(options);
  ASSERT_TRUE(factory);
  EXPECT_NEAR(2, factory->extent()[0].west, 0.1);
  EXPECT_NEAR(18, factory->extent()[0].east, 0.1);
  const NodeLattice lattice = geodetic(4, 64);
  const auto [i0, j0] = nodeAt(lattice, 0, 0);
  const auto got = sampleNodes(*factory, lattice, i0, j0, 113, 113);
  int inside = 0;
  for (int b = 0; b < 113; ++b)
    for (int a = 0; a < 113; ++a) {
      OGRPoint point(lattice.longitude(i0 + a), lattice.latitude(j0 + b));
      const bool within = outer.isPointInRing(&point, FALSE) && !inner.isPointInRing(&point, FALSE);
      const float h = got[std::size_t(b * 113 + a)];
      ASSERT_EQ(within, h == h) << point.getX() << "," << point.getY();
      inside += within;
    }
  EXPECT_GT(inside, 1000);
}

TEST(Cutline, InAnotherSystemAndOverlapping) {
  SourceOptions options = optionsFor(write(degreeRaster(10, 50, 400, 4)));
  // Two squares of 100 km that overlap by half: the union counts, not the exclusive or.
  options.input.cutline = writeText(
      "utm.geojson",
      geoJson(
          R"({"type":"MultiPolygon","coordinates":[[[[400000,5200000],[500000,5200000],[500000,5300000],)"
          R"([400000,5300000],[400000,5200000]]],[[[450000,5200000],[550000,5200000],)"
          R"([550000,5300000],[450000,5300000],[450000,5200000]]]]})",
          "urn:ogc:def:crs:EPSG::32633"));
  const FactoryPtr factory = openSource(options);
  ASSERT_TRUE(factory) << "UTM 33";
  const NodeLattice lattice = geodetic(9, 64);
  const auto at = [&](double lon, double lat) {
    const auto [i, j] = nodeAt(lattice, lon, lat);
    const float h = sampleNode(*factory, lattice, i, j);
    return h == h;
  };
  EXPECT_TRUE(at(13.8, 47.4));
  EXPECT_TRUE(at(13.99, 47.4)) << "in the overlap were it wider";
  EXPECT_FALSE(at(13.5, 47.4));
  EXPECT_FALSE(at(13.8, 46.9));
}

TEST(Cutline, WithoutPolygonsIsAnError) {
  SourceOptions options = optionsFor(write(degreeRaster(0, 20, 200, 20)));
  std::vector<std::string> warnings;
  for (const std::string& path :
       {writeText("points.geojson", geoJson(R"({"type":"Point","coordinates":[1,2]})")),
        writeText("none.txt", "nothing"), std::string("/vsimem/gdalio/missing.shp")}) {
    options.input.cutline = path;
    const auto opened = openRasterSource(options.input, options.heights, warnings);
    EXPECT_EQ(Code::input, opened.status().code());
    EXPECT_NE(std::string::npos, opened.status().message().find(path)) << opened.status().message();
  }
  options.input.cutline =
      writeText("far.geojson",
                geoJson(R"({"type":"Polygon","coordinates":[[[60,1],[70,1],[70,9],[60,1]]]})"));
  EXPECT_EQ(Code::input,
            openRasterSource(options.input, options.heights, warnings).status().code());
}

} // namespace
} // namespace qmesh
