// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Time to sample the 257 x 257 nodes of a tile from a tiled, compressed GeoTIFF in memory, reading
// and decompression included (GDAL's block cache is emptied between rounds): from UTM and from
// degrees, with each kernel. The raster is made here; cells and nodes are about as far apart.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "base/enum_table.h"
#include "source/raster_source.h"

namespace qmesh {
namespace {

constexpr int kPixels = 2048;
constexpr int kCells = 256;
constexpr int kZoom = 12;
constexpr int kTilesAcross = 4;

/// A raster around 11.5 E 47 N, hills in Int16.
std::string makeRaster(const char* srsText, std::array<double, 6> transform) {
  GDALAllRegister();
  const std::string path = std::string("/vsimem/bench-") + (srsText + 5) + ".tif";
  const char* const options[] = {"TILED=YES", "COMPRESS=DEFLATE", "PREDICTOR=2", nullptr};
  GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      path.c_str(), kPixels, kPixels, 1, GDT_Int16, const_cast<char**>(options));
  OGRSpatialReference srs;
  srs.SetFromUserInput(srsText);
  dataset->SetSpatialRef(&srs);
  dataset->SetGeoTransform(transform.data());
  std::vector<std::int16_t> row(kPixels);
  for (int r = 0; r < kPixels; ++r) {
    for (int c = 0; c < kPixels; ++c)
      row[std::size_t(c)] = std::int16_t(1500 + 700 * std::sin(c * 0.013) * std::cos(r * 0.017) +
                                         40 * std::sin(c * 0.31 + r * 0.27));
    if (dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, r, kPixels, 1, row.data(), kPixels, 1,
                                            GDT_Int16, 0, 0, nullptr) != CE_None)
      break;
  }
  GDALClose(dataset);
  return path;
}

/// Samples 4 x 4 tiles inside the raster in one window a round.
void sampleTiles(benchmark::State& state, const std::string& path, double lon, double lat,
                 Resampling kernel) {
  InputOptions options;
  options.path = path;
  options.resampling = kernel;
  std::vector<std::string> warnings;
  const auto factory = openRasterSource(options, {}, warnings);
  if (!factory.ok())
    return state.SkipWithError(factory.status().message().c_str());
  const NodeLattice lattice(Scheme(Profile::geodetic), kZoom, kCells);
  const auto i0 = std::int64_t((lon + 180) / lattice.spacingDegrees());
  const auto j0 = std::int64_t((lat + 90) / lattice.spacingDegrees());
  constexpr int kSide = kTilesAcross * kCells + 1;
  std::vector<float> nodes(std::size_t(kSide) * kSide);
  double tiles = 0;
  for (auto _ : state) {
    auto source = (*factory)->open(lattice);
    const Status status = (*source)->sample(i0, j0, kSide, kSide, nodes.data(), kSide);
    if (!status.ok() || std::isnan(nodes.front()) || std::isnan(nodes.back()))
      return state.SkipWithError("the window is not inside the raster");
    tiles += kTilesAcross * kTilesAcross;
  }
  state.counters["time/tile"] =
      benchmark::Counter(tiles, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void fromUtm(benchmark::State& state) {
  static const std::string path = makeRaster("EPSG:32632", {660000, 20, 0, 5240000, 0, -20});
  const auto kernel = Resampling(state.range(0));
  state.SetLabel(enumName(kernel));
  sampleTiles(state, path, 11.2, 47.03, kernel);
}

void fromDegrees(benchmark::State& state) {
  static const std::string path =
      makeRaster("EPSG:4326", {11, 1.0 / 5400, 0, 47.3, 0, -1.0 / 5400});
  const auto kernel = Resampling(state.range(0));
  state.SetLabel(enumName(kernel));
  sampleTiles(state, path, 11.05, 47.0, kernel);
}

BENCHMARK(fromUtm)->DenseRange(0, int(Resampling::average))->Unit(benchmark::kMillisecond);
BENCHMARK(fromDegrees)->DenseRange(0, int(Resampling::average))->Unit(benchmark::kMillisecond);

} // namespace
} // namespace qmesh
