// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// What is opened is closed, on every way out of CreateCopy and Open; run under LeakSanitizer, too.
#include <ogrsf_frmts.h>

#include "driver_fixture.h"

namespace qmesh {
namespace {

/// Reads one row of the raster and one feature of each layer.
void touch(GDALDataset& set) {
  std::vector<float> row(std::size_t(set.GetRasterXSize()));
  ASSERT_EQ(CE_None, set.GetRasterBand(1)->RasterIO(GF_Read, 0, set.GetRasterYSize() / 2,
                                                    int(row.size()), 1, row.data(), int(row.size()),
                                                    1, GDT_Float32, 0, 0, nullptr));
  for (int k = 0; k < set.GetLayerCount(); ++k)
    delete set.GetLayer(k)->GetNextFeature();
}

TEST_F(DriverTest, CreatesReopensAndDeletes) {
  for (int round = 0; round < 3; ++round) {
    GDALDatasetUniquePtr made = create(*input_, {"MAX_ZOOM=6"});
    ASSERT_TRUE(made);
    touch(*made);
    GDALDatasetUniquePtr again(GDALDataset::Open(kPlace, GDAL_OF_RASTER | GDAL_OF_VECTOR));
    ASSERT_TRUE(again);
    touch(*again);
  }
  EXPECT_EQ(CE_None, driver().Delete(kPlace));
  EXPECT_EQ(nullptr, GDALIdentifyDriver(kPlace, nullptr));
}

TEST_F(DriverTest, OpensTheInputAgainForEveryThreadAndClosesIt) {
  const GDALDatasetUniquePtr memory(GetGDALDriverManager()->GetDriverByName("MEM")->CreateCopy(
      "", input_.get(), FALSE, nullptr, nullptr, nullptr));
  for (GDALDataset* source : {input_.get(), memory.get()}) {
    const int before = openDatasets();
    {
      const GDALDatasetUniquePtr made =
          create(*source, {"NUM_THREADS=4", "VOID_FILL=interpolate", "TITLE=t"});
      ASSERT_TRUE(made);
    }
    EXPECT_EQ(before, openDatasets());
  }
}

TEST_F(DriverTest, RefusalsLeaveNothingOpen) {
  for (const char* option : {"METHOD=none", "MEMORY=1KB", "MAX_X=0", "NO_SUCH=1"}) {
    Messages messages;
    EXPECT_FALSE(create(*input_, {option})) << option;
    EXPECT_EQ(1, messages.failures) << option << ": " << messages.text;
  }
}

int CPL_STDCALL stopInTheMiddle(double done, const char*, void*) {
  return done == 0;
}

TEST_F(DriverTest, ACancelLeavesNothing) {
  Messages messages;
  EXPECT_FALSE(create(*input_, {}, stopInTheMiddle));
  EXPECT_EQ(1, messages.failures);
  EXPECT_EQ(CPLE_UserInterrupt, messages.number);
  VSIStatBufL info;
  EXPECT_NE(0, VSIStatL(kPlace, &info));
}

TEST_F(DriverTest, RegistersOnce) {
  const int before = GDALGetDriverCount();
  QMESHRegister();
  EXPECT_EQ(before, GDALGetDriverCount());
}

} // namespace
} // namespace qmesh
