// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include "source/raster_source.h"

namespace qmesh {

inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A raster in GDAL's memory file system, made by a test and removed with it.
struct MadeRaster {
  int width = 10;
  int height = 10;
  std::array<double, 6> geoTransform{0, 1, 0, 10, 0, -1};
  std::string srs = "EPSG:4326"; ///< empty: none
  GDALDataType type = GDT_Float32;
  std::optional<double> nodata;
  /// Value of a pixel; NaN stands for nodata where there is one.
  std::function<double(int column, int row)> value = [](int, int) { return 0; };
  std::function<void(GDALDataset&)> finish = [](GDALDataset&) {};
  int bands = 1;

  /// Position of a pixel's centre in the raster's coordinate system.
  std::array<double, 2> centre(int column, int row) const {
    const auto& g = geoTransform;
    const double c = column + 0.5;
    const double r = row + 0.5;
    return {g[0] + c * g[1] + r * g[2], g[3] + c * g[4] + r * g[5]};
  }
};

inline void writePixels(const MadeRaster& made, GDALDataset& dataset) {
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  if (made.nodata)
    band.SetNoDataValue(*made.nodata);
  std::vector<double> line(std::size_t(made.width));
  for (int r = 0; r < made.height; ++r) {
    for (int c = 0; c < made.width; ++c) {
      const double v = made.value(c, r);
      line[std::size_t(c)] = std::isnan(v) && made.nodata ? *made.nodata : v;
    }
    ASSERT_EQ(CE_None, band.RasterIO(GF_Write, 0, r, made.width, 1, line.data(), made.width, 1,
                                     GDT_Float64, 0, 0, nullptr));
  }
}

/// Writes it as a GeoTIFF; returns its path.
inline std::string write(const MadeRaster& made, const std::string& name = "raster.tif") {
  GDALAllRegister();
  const std::string path = "/vsimem/gdalio/" + name;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDataset* dataset =
      driver->Create(path.c_str(), made.width, made.height, made.bands, made.type, nullptr);
  if (made.geoTransform != std::array<double, 6>{0, 1, 0, 0, 0, 1}) {
    auto transform = made.geoTransform;
    dataset->SetGeoTransform(transform.data());
  }
  if (!made.srs.empty()) {
    OGRSpatialReference srs;
    EXPECT_EQ(OGRERR_NONE, srs.SetFromUserInput(made.srs.c_str()));
    srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    dataset->SetSpatialRef(&srs);
  }
  writePixels(made, *dataset);
  made.finish(*dataset);
  GDALClose(dataset);
  return path;
}

using FactoryPtr = std::shared_ptr<NodeSourceFactory>;

/// What a raster source is made of.
struct SourceOptions {
  InputOptions input;
  HeightOptions heights;
};

inline SourceOptions optionsFor(const std::string& path) {
  SourceOptions options;
  options.input.path = path;
  return options;
}

inline FactoryPtr openSource(const SourceOptions& options,
                             std::vector<std::string>* warnings = nullptr) {
  std::vector<std::string> ignored;
  auto opened = openRasterSource(options.input, options.heights, warnings ? *warnings : ignored);
  EXPECT_TRUE(opened.ok()) << opened.status().message();
  return opened.ok() ? *opened : nullptr;
}

/// Nodes i0.., j0.. of a lattice in one call.
inline std::vector<float> sampleNodes(const NodeSourceFactory& factory, const NodeLattice& lattice,
                                      std::int64_t i0, std::int64_t j0, int width, int height) {
  auto source = factory.open(lattice);
  EXPECT_TRUE(source.ok()) << source.status().message();
  std::vector<float> out(std::size_t(width) * std::size_t(height), -12345.0f);
  if (source.ok()) {
    const Status status = (*source)->sample(i0, j0, width, height, out.data(), width);
    EXPECT_TRUE(status.ok()) << status.message();
  }
  return out;
}

inline float sampleNode(const NodeSourceFactory& factory, const NodeLattice& lattice,
                        std::int64_t i, std::int64_t j) {
  return sampleNodes(factory, lattice, i, j, 1, 1)[0];
}

inline NodeLattice geodetic(int zoom, int cells) {
  return {Scheme(Profile::geodetic), zoom, cells};
}
inline NodeLattice mercator(int zoom, int cells) {
  return {Scheme(Profile::mercator), zoom, cells};
}

/// The node nearest to a place.
inline std::array<std::int64_t, 2> nodeAt(const NodeLattice& lattice, double lon, double lat) {
  return {std::llround(lattice.scheme().fractionX(lon) * double(lattice.columns())),
          std::llround(lattice.scheme().fractionY(lat) * double(lattice.lastRow()))};
}

inline std::string nameOf(Resampling resampling) {
  static const char* const names[] = {"nearest",     "bilinear", "cubic",
                                      "cubicspline", "lanczos",  "average"};
  return names[int(resampling)];
}

} // namespace qmesh
