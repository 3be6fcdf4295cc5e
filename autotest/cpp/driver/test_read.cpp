// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Sets in GDAL's memory, opened, read and closed again: with the sanitizers this is where a
// dataset, layer or feature that is not given back shows.
#include <gtest/gtest.h>

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <vector>

#include "codec/encode.h"
#include "codec/gzip.h"
#include "codec/layer_json.h"
#include "qmesh_driver.h"
#include "vsi/quiet_errors.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

struct Closer {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Closer>;
using Feature = std::unique_ptr<OGRFeature>;

/// A slope from 0 m in the south to 100 m in the north.
std::vector<std::uint8_t> slopeTile() {
  TileMesh mesh;
  mesh.header.maxHeight = 100;
  mesh.u = {0, 32767, 32767, 0};
  mesh.v = {0, 0, 32767, 32767};
  mesh.q = {0, 0, 32767, 32767};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.edges = {{{0, 3}, {0, 1}, {1, 2}, {2, 3}}};
  return *encodeTile(mesh);
}

class DriverRead : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    GDALAllRegister();
    QMESHRegister();
  }

  void SetUp() override {
    removeTree(kFolder);
    LayerJson layer;
    layer.available = {{{0, 0, 1, 0}}, {{0, 0, 3, 1}}};
    layer.maxZoom = 1;
    const std::string text = writeLayerJson(layer);
    write("layer.json", {text.begin(), text.end()});
    const auto tile = GzipCompressor().compress(slopeTile());
    for (std::uint32_t z = 0; z <= 1; ++z)
      for (std::uint32_t x = 0; x < 2u << z; ++x)
        for (std::uint32_t y = 0; y < 1u << z; ++y)
          write(std::to_string(z) + "/" + std::to_string(x) + "/" + std::to_string(y) + ".terrain",
                tile);
  }
  void TearDown() override { removeTree(kFolder); }

  static void write(const std::string& name, const std::vector<std::uint8_t>& bytes) {
    ASSERT_TRUE(writeWholeFile(kFolder + ("/" + name), bytes.data(), bytes.size()).ok());
  }

  static Dataset open(unsigned flags, const std::vector<const char*>& options = {}) {
    std::vector<const char*> list = options;
    list.push_back(nullptr);
    return Dataset(GDALDataset::Open(kFolder, flags, nullptr, list.data(), nullptr));
  }

  static constexpr const char* kFolder = "/vsimem/driver_read";
};

TEST_F(DriverRead, RasterWithOverviews) {
  const Dataset dataset = open(GDAL_OF_RASTER);
  ASSERT_TRUE(dataset);
  GDALRasterBand* band = dataset->GetRasterBand(1);
  ASSERT_EQ(band->GetXSize(), 1024);
  ASSERT_EQ(band->GetOverviewCount(), 1);
  for (GDALRasterBand* level : {band, band->GetOverview(0)}) {
    const int width = level->GetXSize(), height = level->GetYSize();
    std::vector<float> heights(std::size_t(width) * std::size_t(height));
    ASSERT_EQ(CE_None, level->RasterIO(GF_Read, 0, 0, width, height, heights.data(), width, height,
                                       GDT_Float32, 0, 0, nullptr));
    EXPECT_NEAR(heights.front(), 100 * (1 - 0.5 / 256), 1e-4);
    EXPECT_NEAR(heights.back(), 100 * 0.5 / 256, 1e-4);
  }
}

TEST_F(DriverRead, LayersFeatureByFeature) {
  for (const char* geometry : {"GEOMETRY=TIN", "GEOMETRY=MULTIPOLYGON", "GEOMETRY=POLYGONS"}) {
    const Dataset dataset = open(GDAL_OF_VECTOR, {geometry});
    ASSERT_TRUE(dataset);
    for (int k = 0; k < dataset->GetLayerCount(); ++k) {
      OGRLayer* layer = dataset->GetLayer(k);
      GIntBig count = 0;
      while (const Feature feature{layer->GetNextFeature()}) {
        ASSERT_NE(feature->GetGeometryRef(), nullptr);
        const Feature same{layer->GetFeature(feature->GetFID())};
        ASSERT_TRUE(same);
        EXPECT_TRUE(same->Equal(feature.get()));
        ++count;
      }
      EXPECT_EQ(count, layer->GetFeatureCount());
    }
  }
}

TEST_F(DriverRead, NothingStaysBehindAfterAnError) {
  const QuietErrors quiet;
  EXPECT_FALSE(open(GDAL_OF_RASTER, {"ZOOM=9"}));
  EXPECT_FALSE(open(GDAL_OF_RASTER, {"FILL=WATER"}));
  EXPECT_FALSE(open(GDAL_OF_RASTER | GDAL_OF_UPDATE));
  write("1/0/1.terrain", {1, 2, 3});
  const Dataset dataset = open(GDAL_OF_RASTER | GDAL_OF_VECTOR);
  ASSERT_TRUE(dataset);
  float height = 0;
  EXPECT_EQ(CE_Failure, dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 1, 1, &height, 1, 1,
                                                            GDT_Float32, 0, 0, nullptr));
  OGRLayer* triangles = dataset->GetLayerByName("triangles");
  Feature last;
  for (int k = 0; k < 8; ++k)
    last.reset(triangles->GetNextFeature());
  write("layer.json", {'{'});
  EXPECT_FALSE(open(GDAL_OF_RASTER));
}

} // namespace
} // namespace qmesh
