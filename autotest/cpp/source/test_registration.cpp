// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Plane surfaces come back at their exact places: no half cell anywhere.
#include <random>

#include "made_raster.h"

namespace qmesh {
namespace {

struct Case {
  const char* name;
  const char* srs;
  std::array<double, 6> geoTransform;
  int zoom;
  bool point = false; ///< AREA_OR_POINT=Point in the file
  int size = 200;

  bool lonLat() const { return std::string(srs) == "EPSG:4326"; }
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

const Case kCases[] = {
    {"degrees", "EPSG:4326", {10, 1.0 / 1200, 0, 47, 0, -1.0 / 1200}, 11},
    {"degreesPoint", "EPSG:4326", {10, 1.0 / 1200, 0, 47, 0, -1.0 / 1200}, 11, true},
    {"utm", "EPSG:32611", {376313.7, 30, 0, 3807917.8, 0, -30}, 13},
    {"utmPoint", "EPSG:32611", {376313.7, 30, 0, 3807917.8, 0, -30}, 13, true},
    {"utmMetre", "EPSG:32611", {376313.7, 1, 0, 3807917.8, 0, -1}, 18},
    {"utmCoarseNodes", "EPSG:32611", {376313.7, 30, 0, 3807917.8, 0, -30}, 8, false, 1200},
    {"nad27", "EPSG:26710", {557805, 30, 0, 5122005, 0, -30}, 13},
    {"polar", "EPSG:3031", {-100000, 1000, 0, 100000, 0, -1000}, 7},
    {"polarArctic", "EPSG:3413", {-100000, 1000, 0, -500000, 0, -1000}, 7},
    {"rotated", "EPSG:32633", {500000, 21, 21, 5100000, 21, -21}, 13},
    {"southUp", "EPSG:32633", {500000, 30, 0, 5100000, 0, 30}, 13},
    {"utmVeryCoarse", "EPSG:32611", {376313.7, 5, 0, 3807917.8, 0, -5}, 8, false, 3000},
    {"lambert", "EPSG:2154", {700000, 5000, 0, 7100000, 0, -5000}, 5},
};

class Registration : public testing::TestWithParam<std::tuple<Case, Resampling>> {};

/// The plane's value at a place, by a transformation of the test's own.
class Plane {
 public:
  explicit Plane(const MadeRaster& made) : origin_(made.centre(0, 0)) {
    const auto& g = made.geoTransform;
    slopeX_ = 7.0 / std::hypot(g[1], g[4]); // 7 m a pixel
    slopeY_ = -5.0 / std::hypot(g[2], g[5]);
    OGRSpatialReference lonLat, srs;
    lonLat.importFromEPSG(4326);
    srs.SetFromUserInput(made.srs.c_str());
    lonLat.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    transform_.reset(OGRCreateCoordinateTransformation(&lonLat, &srs));
  }
  double atWorld(double x, double y) const {
    return (x - origin_[0]) * slopeX_ + (y - origin_[1]) * slopeY_;
  }
  /// Place to position in the raster's system.
  std::array<double, 2> world(double lon, double lat) const {
    transform_->Transform(1, &lon, &lat);
    return {lon, lat};
  }

 private:
  std::array<double, 2> origin_;
  double slopeX_, slopeY_;
  std::unique_ptr<OGRCoordinateTransformation> transform_;
};

TEST_P(Registration, PlaneComesBackExactly) {
  const auto& [c, resampling] = GetParam();
  MadeRaster made;
  made.width = made.height = c.size;
  made.geoTransform = c.geoTransform;
  made.srs = c.srs;
  made.type = GDT_Float64;
  const Plane plane(made);
  made.value = [&](int column, int row) {
    const auto p = made.centre(column, row);
    return plane.atWorld(p[0], p[1]);
  };
  if (c.point)
    made.finish = [](GDALDataset& d) { d.SetMetadataItem("AREA_OR_POINT", "Point"); };
  SourceOptions options = optionsFor(write(made));
  options.input.resampling = resampling;
  const FactoryPtr factory = openSource(options);
  ASSERT_TRUE(factory);
  const NodeLattice lattice = geodetic(c.zoom, 64);
  const GeoBox box = factory->extent()[0];
  const auto [i, j] = nodeAt(lattice, (box.west + box.east) / 2, (box.south + box.north) / 2);
  const int n = 60;
  const std::int64_t j0 = std::clamp<std::int64_t>(j - n / 2, 0, lattice.lastRow() - n);
  const std::vector<float> got = sampleNodes(*factory, lattice, i - n / 2, j0, n, n);
  std::array<double, 6> inverse{};
  auto transform = made.geoTransform;
  ASSERT_TRUE(GDALInvGeoTransform(transform.data(), inverse.data()));
  // Near the rim a cut kernel leans inwards. Node spacing in pixels, more or less:
  const double metres = lattice.spacingDegrees() * 111e3;
  const double cell = std::hypot(transform[1], transform[4]) * (c.lonLat() ? 111e3 : 1);
  const double rim = 3 * std::max(1.0, metres / cell) + 8;
  int valid = 0;
  for (int b = 0; b < n; ++b)
    for (int a = 0; a < n; ++a) {
      const auto p = plane.world(lattice.longitude(i - n / 2 + a), lattice.latitude(j0 + b));
      const double column = inverse[0] + p[0] * inverse[1] + p[1] * inverse[2];
      const double row = inverse[3] + p[0] * inverse[4] + p[1] * inverse[5];
      if (std::min(column, row) < rim || std::max(column, row) > c.size - rim)
        continue;
      ++valid;
      const double want = plane.atWorld(p[0], p[1]);
      // 1/1000 pixel on a slope of 7 + 5 m a pixel, and the rounding to float32.
      ASSERT_NEAR(want, got[std::size_t(b * n + a)], 0.012 + 3e-7 * std::abs(want))
          << "node " << a << "," << b << ", pixel " << column << "," << row;
    }
  EXPECT_GT(valid, 4);
}

std::string nameOfCase(const testing::TestParamInfo<Registration::ParamType>& c) {
  return std::string(std::get<0>(c.param).name) + "_" + nameOf(std::get<1>(c.param));
}

INSTANTIATE_TEST_SUITE_P(All, Registration,
                         testing::Combine(testing::ValuesIn(kCases),
                                          testing::Values(Resampling::bilinear, Resampling::cubic,
                                                          Resampling::cubicspline,
                                                          Resampling::lanczos)),
                         nameOfCase);

/// Nodes on pixel centres take the pixel's value to the bit, nearest as well as bilinear.
TEST(RegistrationOnCentres, NodesOnPixelCentresTakeThePixel) {
  MadeRaster made;
  made.width = made.height = 32;
  const NodeLattice lattice = geodetic(3, 64);
  const double s = lattice.spacingDegrees();
  made.geoTransform = {-s / 2, s, 0, 45 + s / 2, 0, -s};
  std::mt19937 random(7);
  std::vector<float> pixels(32 * 32);
  for (float& p : pixels)
    p = float(random() % 4000);
  made.value = [&](int c, int r) { return pixels[std::size_t(r * 32 + c)]; };
  SourceOptions options = optionsFor(write(made));
  for (Resampling resampling : {Resampling::nearest, Resampling::bilinear, Resampling::cubic,
                                Resampling::lanczos, Resampling::average}) {
    options.input.resampling = resampling;
    const FactoryPtr factory = openSource(options);
    ASSERT_TRUE(factory);
    const auto [i, j] = nodeAt(lattice, 0, 45);
    for (int r = 4; r < 28; ++r)
      for (int c = 4; c < 28; ++c)
        ASSERT_NEAR(pixels[std::size_t(r * 32 + c)], sampleNode(*factory, lattice, i + c, j - r),
                    resampling == Resampling::lanczos ? 1e-2 : 0);
  }
}

} // namespace
} // namespace qmesh
