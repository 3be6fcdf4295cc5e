// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Inputs that cannot be used say why; odd ones that can be used work.
#include <random>

#include <cpl_conv.h>
#include <cpl_string.h>

#include "made_raster.h"

namespace qmesh {
namespace {

void expectRefused(const SourceOptions& options, Code code,
                   std::initializer_list<const char*> words) {
  std::vector<std::string> warnings;
  const auto opened = openRasterSource(options.input, options.heights, warnings);
  ASSERT_FALSE(opened.ok());
  const std::string& message = opened.status().message();
  EXPECT_EQ(code, opened.status().code()) << message;
  for (const char* word : words)
    EXPECT_NE(std::string::npos, message.find(word)) << message << " lacks " << word;
  EXPECT_EQ(std::string::npos, message.find('\n')) << message;
}

TEST(BadInput, MissingFileAndNoRaster) {
  expectRefused(optionsFor("/vsimem/gdalio/none.tif"), Code::input, {"none.tif", "does not exist"});
  VSILFILE* file = VSIFOpenL("/vsimem/gdalio/text.txt", "wb");
  VSIFWriteL("hello", 1, 5, file);
  VSIFCloseL(file);
  expectRefused(optionsFor("/vsimem/gdalio/text.txt"), Code::input, {"text.txt", "not a raster"});
}

TEST(BadInput, GeoreferencingAndCoordinateSystem) {
  MadeRaster made;
  made.geoTransform = {0, 1, 0, 0, 0, 1};
  expectRefused(optionsFor(write(made)), Code::input, {"raster.tif", "not georeferenced"});
  made.finish = [](GDALDataset& d) {
    GDAL_GCP gcps[4];
    GDALInitGCPs(4, gcps);
    for (int k = 0; k < 4; ++k) {
      gcps[k].dfGCPPixel = k % 2 * 10;
      gcps[k].dfGCPLine = k / 2 * 10;
      gcps[k].dfGCPX = k % 2;
      gcps[k].dfGCPY = k / 2 + 0.1 * k;
    }
    OGRSpatialReference srs;
    srs.importFromEPSG(4326);
    d.SetGCPs(4, gcps, &srs);
    GDALDeinitGCPs(4, gcps);
  };
  made.srs = "";
  SourceOptions options = optionsFor(write(made));
  options.input.sourceSrs = "EPSG:4326";
  expectRefused(options, Code::input, {"control points", "gdalwarp"});

  made = MadeRaster();
  made.srs = "";
  options = optionsFor(write(made));
  expectRefused(options, Code::input, {"raster.tif", "-s EPSG:4326"});
  options.input.sourceSrs = "EPSG:4326";
  EXPECT_TRUE(openSource(options)) << "-s cures it";
  options.input.sourceSrs = "EPSG:bogus";
  expectRefused(options, Code::usage, {"EPSG:bogus", "-s"});
  made.srs = R"(LOCAL_CS["harbour",UNIT["metre",1]])";
  expectRefused(optionsFor(write(made)), Code::input, {"harbour", "-s"});
  made = MadeRaster();
  made.geoTransform = {0, 1, 1, 0, 1, 1};
  expectRefused(optionsFor(write(made)), Code::input, {"cannot be inverted"});
}

TEST(BadInput, Bands) {
  MadeRaster made;
  SourceOptions options = optionsFor(write(made));
  options.input.band = 2;
  expectRefused(options, Code::input, {"no band 2", "1 to 1"});
  options.input.band = 0;
  expectRefused(options, Code::input, {"no band 0"});
  made.type = GDT_CFloat32;
  expectRefused(optionsFor(write(made)), Code::input, {"complex"});
  VSILFILE* file = VSIFOpenL("/vsimem/gdalio/empty.vrt", "wb");
  const std::string vrt = R"(<VRTDataset rasterXSize="5" rasterYSize="5"></VRTDataset>)";
  VSIFWriteL(vrt.data(), 1, vrt.size(), file);
  VSIFCloseL(file);
  expectRefused(optionsFor("/vsimem/gdalio/empty.vrt"), Code::input, {"empty.vrt", "bands"});
}

TEST(BadInput, SeveralRastersInOneFile) {
  MadeRaster made;
  made.type = GDT_Byte;
  const GDALDatasetUniquePtr raster(GDALDataset::Open(write(made).c_str()));
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (!driver)
    GTEST_SKIP() << "this GDAL has no GPKG driver";
  const char* path = "/vsimem/gdalio/two.gpkg";
  for (const char* table : {"one", "two"}) {
    CPLStringList creation;
    creation.SetNameValue("RASTER_TABLE", table);
    creation.SetNameValue("APPEND_SUBDATASET", table[0] == 't' ? "YES" : "NO");
    GDALClose(driver->CreateCopy(path, raster.get(), FALSE, creation.List(), nullptr, nullptr));
  }
  expectRefused(optionsFor(path), Code::input, {"two.gpkg", "several rasters", "GPKG:"});
}

TEST(BadInput, NowhereOnTheGlobe) {
  MadeRaster made;
  made.srs = "EPSG:32633";
  made.geoTransform = {1e12, 1e9, 0, 1e12, 0, -1e9};
  std::vector<std::string> warnings;
  const auto opened = openRasterSource(optionsFor(write(made)).input, {}, warnings);
  EXPECT_EQ(Code::input, opened.status().code());
}

TEST(BadInput, DamagedFileIsAnErrorOfTheRead) {
  MadeRaster made;
  made.width = made.height = 300;
  made.geoTransform = {0, 0.1, 0, 40, 0, -0.1};
  std::mt19937 random(3);
  made.value = [&](int, int) { return double(random()); };
  const std::string path = write(made);
  VSILFILE* file = VSIFOpenL(path.c_str(), "r+b");
  VSIFTruncateL(file, 200000);
  VSIFCloseL(file);
  const FactoryPtr factory = openSource(optionsFor(path));
  ASSERT_TRUE(factory);
  const NodeLattice lattice = geodetic(3, 64);
  auto source = factory->open(lattice);
  ASSERT_TRUE(source.ok());
  std::vector<float> out(80 * 80);
  const auto [i, j] = nodeAt(lattice, 1, 11);
  const Status status = (*source)->sample(i, j, 80, 80, out.data(), 80);
  EXPECT_EQ(Code::input, status.code());
  EXPECT_NE(std::string::npos, status.message().find(path)) << status.message();
}

TEST(OddInput, ErrorsAreNotPrinted) {
  testing::internal::CaptureStderr();
  std::vector<std::string> warnings;
  (void)openRasterSource(optionsFor("/vsimem/gdalio/none.tif").input, {}, warnings).ok();
  EXPECT_EQ("", testing::internal::GetCapturedStderr());
}

TEST(OddInput, OnePixel) {
  MadeRaster made;
  made.width = made.height = 1;
  made.geoTransform = {10, 1, 0, 50, 0, -1};
  made.value = [](int, int) { return 77; };
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  const NodeLattice lattice = geodetic(5, 64);
  const auto [i, j] = nodeAt(lattice, 10.5, 49.5);
  EXPECT_EQ(77, sampleNode(*factory, lattice, i, j));
  EXPECT_EQ(10, factory->extent()[0].west);
  EXPECT_EQ(0, factory->nativeZoom(Scheme(Profile::geodetic), 256));
}

TEST(OddInput, SmallerThanANodeCell) {
  MadeRaster made;
  made.width = made.height = 3;
  made.geoTransform = {10.001, 1e-5, 0, 50.001, 0, -1e-5};
  made.value = [](int, int) { return 5; };
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  for (float h : sampleNodes(*factory, geodetic(2, 64), 0, 0, 512, 257))
    ASSERT_TRUE(h != h);
  EXPECT_TRUE(*factory->hasData());
}

TEST(OddInput, LongAndThin) {
  for (bool tall : {true, false}) {
    MadeRaster made;
    made.width = tall ? 2 : 100000;
    made.height = tall ? 100000 : 2;
    made.type = GDT_Int16;
    made.geoTransform = {10, 1e-4, 0, 50, 0, -1e-4};
    made.value = [](int c, int r) { return (c + r) % 100; };
    const FactoryPtr factory = openSource(optionsFor(write(made)));
    ASSERT_TRUE(factory);
    EXPECT_NEAR(tall ? 10.0002 : 20, factory->extent()[0].east, 1e-9);
    const NodeLattice fine = geodetic(13, 256);
    const auto [i, j] = nodeAt(fine, 10.0001, 49.9999);
    const auto got = sampleNodes(*factory, fine, i - 2, tall ? j - 2000 : j - 2, tall ? 5 : 2000,
                                 tall ? 2000 : 5);
    int valid = 0;
    for (float h : got)
      valid += h == h;
    EXPECT_GT(valid, 1500);
    const NodeLattice coarse = geodetic(3, 64);
    const auto far = sampleNodes(*factory, coarse, 0, 0, 1024, 513);
    EXPECT_EQ(1024u * 513u, far.size());
  }
}

TEST(OddInput, VrtZipAndSubBand) {
  MadeRaster made;
  made.geoTransform = {10, 0.1, 0, 50, 0, -0.1};
  made.bands = 2;
  made.value = [](int c, int r) { return c * r; };
  made.finish = [](GDALDataset& d) { d.GetRasterBand(2)->Fill(9); };
  const std::string path = write(made);
  const NodeLattice lattice = geodetic(5, 64);
  const auto [i, j] = nodeAt(lattice, 10.5, 49.5);
  const float want = sampleNode(*openSource(optionsFor(path)), lattice, i, j);
  SourceOptions second = optionsFor(path);
  second.input.band = 2;
  EXPECT_EQ(9, sampleNode(*openSource(second), lattice, i, j));

  GDALDataset* source = GDALDataset::Open(path.c_str(), GDAL_OF_RASTER);
  GDALDriver* vrt = GetGDALDriverManager()->GetDriverByName("VRT");
  GDALClose(vrt->CreateCopy("/vsimem/gdalio/copy.vrt", source, FALSE, nullptr, nullptr, nullptr));
  GDALClose(source);
  EXPECT_EQ(want, sampleNode(*openSource(optionsFor("/vsimem/gdalio/copy.vrt")), lattice, i, j));

  void* zip = CPLCreateZip("/vsimem/gdalio/dem.zip", nullptr);
  vsi_l_offset size = 0;
  GByte* bytes = VSIGetMemFileBuffer(path.c_str(), &size, FALSE);
  CPLCreateFileInZip(zip, "dem.tif", nullptr);
  CPLWriteFileInZip(zip, bytes, int(size));
  CPLCloseFileInZip(zip);
  CPLCloseZip(zip);
  EXPECT_EQ(want, sampleNode(*openSource(optionsFor("/vsizip//vsimem/gdalio/dem.zip/dem.tif")),
                             lattice, i, j));
}

TEST(OddInput, CompoundSystemUsesItsHorizontalPart) {
  MadeRaster made;
  made.geoTransform = {10, 0.1, 0, 50, 0, -0.1};
  made.srs = "EPSG:4326+5773";
  made.value = [](int, int) { return 250; };
  const FactoryPtr factory = openSource(optionsFor(write(made)));
  ASSERT_TRUE(factory);
  const NodeLattice lattice = geodetic(5, 64);
  const auto [i, j] = nodeAt(lattice, 10.5, 49.5);
  EXPECT_EQ(250, sampleNode(*factory, lattice, i, j));
}

} // namespace
} // namespace qmesh
