// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <cpl_string.h>

#include "made_raster.h"
#include "qmesh_driver.h"

namespace qmesh {

/// The driver registered in this process, and a hilly DEM to write.
class DriverTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    GDALAllRegister();
    QMESHRegister();
  }

  void SetUp() override {
    openBefore_ = openDatasets();
    MadeRaster made;
    made.width = 64;
    made.height = 48;
    made.geoTransform = {10, 0.01, 0, 47, 0, -0.01};
    made.nodata = -999;
    made.value = [](int c, int r) { return 500 + 200 * std::sin(c / 7.0) * std::cos(r / 5.0); };
    path_ = write(made, "driver.tif");
    openInput();
  }

  /// Every test ends with as many open datasets as it began with.
  void TearDown() override {
    input_.reset();
    VSIUnlink(path_.c_str());
    VSIRmdirRecursive(kPlace);
    EXPECT_EQ(openBefore_, openDatasets());
  }

  void openInput() { input_.reset(GDALDataset::Open(path_.c_str(), GDAL_OF_RASTER)); }

  static int openDatasets() {
    int count = 0;
    GDALDataset** list = nullptr;
    GDALGetOpenDatasets(reinterpret_cast<GDALDatasetH**>(&list), &count);
    return count;
  }

  static GDALDriver& driver() { return *GetGDALDriverManager()->GetDriverByName("QMESH"); }

  GDALDatasetUniquePtr create(GDALDataset& source, std::vector<const char*> options = {},
                              GDALProgressFunc progress = nullptr, void* data = nullptr) {
    CPLStringList list;
    list.AddString("TILESIZE=32");
    for (const char* option : options)
      list.AddString(option);
    return GDALDatasetUniquePtr(
        driver().CreateCopy(kPlace, &source, FALSE, list.List(), progress, data));
  }

  static constexpr const char* kPlace = "/vsimem/driver_set";

  std::string path_;
  GDALDatasetUniquePtr input_;

 private:
  int openBefore_ = 0;
};

/// Keeps GDAL's messages of this thread for its lifetime.
class Messages {
 public:
  Messages() { CPLPushErrorHandlerEx(take, this); }
  ~Messages() { CPLPopErrorHandler(); }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  int failures = 0;
  int warnings = 0;
  CPLErrorNum number = 0;
  std::string text;

 private:
  static void CPL_STDCALL take(CPLErr kind, CPLErrorNum number, const char* text) {
    auto* self = static_cast<Messages*>(CPLGetErrorHandlerUserData());
    ++(kind >= CE_Failure ? self->failures : self->warnings);
    self->number = number;
    self->text = text;
  }
};

} // namespace qmesh
