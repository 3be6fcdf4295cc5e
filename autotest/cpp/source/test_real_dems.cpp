// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Real DEMs (folder QMESH_TEST_DATA) against bilinear interpolation written out once more, with a
// PROJ transform of every node.
#include <cstdlib>
#include <filesystem>
#include <random>

#include "made_raster.h"

namespace qmesh {
namespace {

/// The input read by the test itself.
class Reference {
 public:
  explicit Reference(const std::string& path)
      : dataset_(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER)),
        band_(dataset_->GetRasterBand(1)), width_(dataset_->GetRasterXSize()),
        height_(dataset_->GetRasterYSize()), pixels_(std::size_t(width_) * std::size_t(height_)) {
    EXPECT_EQ(CE_None, band_->RasterIO(GF_Read, 0, 0, width_, height_, pixels_.data(), width_,
                                       height_, GDT_Float64, 0, 0, nullptr));
    nodata_ = band_->GetNoDataValue();
    std::array<double, 6> forward{};
    dataset_->GetGeoTransform(forward.data());
    EXPECT_TRUE(GDALInvGeoTransform(forward.data(), inverse_.data()));
    OGRSpatialReference lonLat;
    lonLat.importFromEPSG(4326);
    lonLat.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference srs = *dataset_->GetSpatialRef();
    srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    transform_.reset(OGRCreateCoordinateTransformation(&lonLat, &srs));
  }

  /// Height at a place, and by how much it changes within a pixel; nothing near voids and the rim.
  bool at(double lon, double lat, double& height, double& range) const {
    transform_->Transform(1, &lon, &lat);
    const double x = inverse_[0] + lon * inverse_[1] + lat * inverse_[2] - 0.5;
    const double y = inverse_[3] + lon * inverse_[4] + lat * inverse_[5] - 0.5;
    const int c = int(std::floor(x)), r = int(std::floor(y));
    if (c < 0 || r < 0 || c + 1 >= width_ || r + 1 >= height_)
      return false;
    double low = 1e9, high = -1e9;
    height = 0;
    for (int k = 0; k < 4; ++k) {
      const double p = pixels_[std::size_t((r + k / 2) * width_ + c + k % 2)];
      if (p == nodata_)
        return false;
      height += p * (k % 2 ? x - c : c + 1 - x) * (k / 2 ? y - r : r + 1 - y);
      low = std::min(low, p);
      high = std::max(high, p);
    }
    range = high - low;
    return true;
  }

 private:
  GDALDatasetUniquePtr dataset_;
  GDALRasterBand* band_;
  int width_, height_;
  std::vector<double> pixels_;
  double nodata_ = 0;
  std::array<double, 6> inverse_{};
  std::unique_ptr<OGRCoordinateTransformation> transform_;
};

void compare(const std::string& path) {
  SCOPED_TRACE(path);
  const FactoryPtr factory = openSource(optionsFor(path));
  ASSERT_TRUE(factory);
  EXPECT_TRUE(*factory->hasData());
  const Reference reference(path);
  std::mt19937 random(4711);
  const GeoBox box = factory->extent()[0];
  for (const Profile profile : {Profile::geodetic, Profile::mercator}) {
    const Scheme scheme(profile);
    const NodeLattice lattice(scheme, factory->nativeZoom(scheme, 256), 256);
    auto source = factory->open(lattice);
    ASSERT_TRUE(source.ok());
    int compared = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      const double u = double(random()) / 4294967296.0;
      const double v = double(random()) / 4294967296.0;
      const auto [i, j] = nodeAt(lattice, box.west + u * (box.east - box.west),
                                 std::clamp(box.south + v * (box.north - box.south), -85.0, 85.0));
      float got = 0;
      ASSERT_TRUE((*source)->sample(i, j, 1, 1, &got, 1).ok());
      double want = 0, range = 0;
      if (!reference.at(lattice.longitude(i), lattice.latitude(j), want, range))
        continue;
      ++compared;
      // 1/512 pixel, or the kernel stretched by the little that the spacing is coarser elsewhere.
      ASSERT_NEAR(want, got, range / 256 + 1e-6 * std::abs(want)) << "node " << i << "," << j;
    }
    EXPECT_GT(compared, 1000);
  }
}

TEST(RealDems, EqualAReferenceInterpolation) {
  const char* folder = std::getenv("QMESH_TEST_DATA");
  if (!folder || !std::filesystem::is_directory(folder))
    GTEST_SKIP() << "QMESH_TEST_DATA names no folder: real DEMs are not tested";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".tif")
      compare(entry.path().string());
}

} // namespace
} // namespace qmesh
