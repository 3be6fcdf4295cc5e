// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// How CreateCopy's threads get at the source: by name where that is the same, else one at a time.
#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include "driver_fixture.h"
#include "source/dataset_access.h"

namespace qmesh {
namespace {

bool shared(GDALDataset& dataset, int band = 1) {
  return DatasetAccess::ofHost(dataset, band).mutex() != nullptr;
}

GDALDatasetUniquePtr openAs(const std::string& path, unsigned flags) {
  return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), flags));
}

TEST_F(DriverTest, OnlyWhatIsProvablyTheSameIsOpenedByName) {
  EXPECT_FALSE(shared(*input_));
  EXPECT_TRUE(shared(*openAs(path_, GDAL_OF_RASTER | GDAL_OF_UPDATE)));
  EXPECT_TRUE(shared(*openAs("GTIFF_DIR:1:" + path_, GDAL_OF_RASTER)));
  EXPECT_TRUE(
      shared(*GDALDatasetUniquePtr(GetGDALDriverManager()->GetDriverByName("MEM")->CreateCopy(
          "", input_.get(), FALSE, nullptr, nullptr, nullptr))));
  EXPECT_TRUE(shared(*input_, 2)) << "a band that is not there is found out later";

  GDALDriver* vrt = GetGDALDriverManager()->GetDriverByName("VRT");
  const std::string mosaic = "/vsimem/gdalio/driver.vrt";
  GDALDatasetUniquePtr(
      vrt->CreateCopy(mosaic.c_str(), input_.get(), FALSE, nullptr, nullptr, nullptr));
  const GDALDatasetUniquePtr opened = openAs(mosaic, GDAL_OF_RASTER);
  EXPECT_FALSE(shared(*opened));
  opened->GetRasterBand(1)->SetOffset(100);
  EXPECT_TRUE(shared(*opened)) << "its XML differs from the file's now";
  VSIUnlink(mosaic.c_str());
  EXPECT_TRUE(shared(*opened));
}

/// Remembers which threads read and whether two did at once.
class WatchedBand : public GDALRasterBand {
 public:
  WatchedBand(GDALDataset* dataset, int columns, int rows) {
    poDS = dataset;
    nBand = 1;
    nRasterXSize = columns;
    nRasterYSize = rows;
    nBlockXSize = columns;
    nBlockYSize = 1;
    eDataType = GDT_Float32;
  }
  CPLErr IReadBlock(int, int row, void* data) override {
    if (reading.exchange(true))
      together = true;
    {
      const std::lock_guard<std::mutex> guard(mutex);
      threads.insert(std::this_thread::get_id());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (row == failAt)
      CPLError(CE_Failure, CPLE_AppDefined, "the tape is torn");
    for (int c = 0; c < nBlockXSize; ++c)
      static_cast<float*>(data)[c] = float(row + c);
    reading = false;
    return row == failAt ? CE_Failure : CE_None;
  }
  std::atomic<bool> reading{false}, together{false};
  std::mutex mutex;
  std::set<std::thread::id> threads;
  int failAt = -1;
};

class WatchedDataset : public GDALDataset {
 public:
  WatchedDataset() {
    nRasterXSize = 200;
    nRasterYSize = 200;
    srs_.SetFromUserInput("EPSG:4326");
    srs_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    SetBand(1, new WatchedBand(this, nRasterXSize, nRasterYSize));
  }
  const OGRSpatialReference* GetSpatialRef() const override { return &srs_; }
  CPLErr GetGeoTransform(double* transform) override {
    const double values[] = {10, 0.01, 0, 47, 0, -0.01};
    std::copy(values, values + 6, transform);
    return CE_None;
  }
  WatchedBand& band() { return static_cast<WatchedBand&>(*GetRasterBand(1)); }

 private:
  OGRSpatialReference srs_;
};

TEST_F(DriverTest, OneHandleIsReadByOneThreadAtATime) {
  // On a busy machine one thread may have read all before another starts: then once more.
  std::size_t readers = 0;
  for (int attempt = 0; attempt < 30 && readers < 2; ++attempt) {
    WatchedDataset watched;
    ASSERT_TRUE(create(watched, {"NUM_THREADS=4", "BLOCK_TILES=2"}));
    EXPECT_FALSE(watched.band().together);
    readers = watched.band().threads.size();
  }
  EXPECT_GT(readers, 1u) << "by several, or this shows nothing";
}

TEST_F(DriverTest, AnErrorOfAWorkerIsOneErrorOfTheCaller) {
  WatchedDataset watched;
  watched.band().failAt = 120;
  Messages messages;
  EXPECT_FALSE(create(watched, {"NUM_THREADS=4"}));
  EXPECT_EQ(1, messages.failures);
  EXPECT_NE(std::string::npos, messages.text.find("cannot be read")) << messages.text;
  EXPECT_NE(std::string::npos, messages.text.find("the tape is torn")) << messages.text;
}

TEST_F(DriverTest, WorkersHaveTheConfigurationOfTheCaller) {
  CPLSetThreadLocalConfigOption("QMESH_TEST_KEY", "of the caller");
  const DatasetAccess access = DatasetAccess::ofHost(*input_, 1);
  std::string seen;
  std::thread([&] {
    access.enterThread();
    seen = CPLGetConfigOption("QMESH_TEST_KEY", "nothing");
  }).join();
  CPLSetThreadLocalConfigOption("QMESH_TEST_KEY", nullptr);
  EXPECT_EQ("of the caller", seen);
}

} // namespace
} // namespace qmesh
