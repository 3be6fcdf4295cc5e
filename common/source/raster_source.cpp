// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/raster_source.h"

#include <limits>

#include "source/cutline.h"
#include "source/extent.h"
#include "source/raster_sampler.h"
#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

/// What GDAL keeps for an open dataset beside its block cache, by experience.
constexpr std::size_t kDatasetBytes = 1 << 20;

class RasterSourceFactory : public NodeSourceFactory {
 public:
  RasterSourceFactory(std::shared_ptr<const SamplerSetup> setup, std::vector<GeoBox> extent)
      : setup_(std::move(setup)), extent_(std::move(extent)) {}

  const std::vector<GeoBox>& extent() const override { return extent_; }

  int nativeZoom(const Scheme& scheme, int cellsPerTile) const override {
    return nativeZoomOf(setup_->input, scheme, cellsPerTile);
  }

  double poleHeight(bool north) const override { return north ? northPole_ : southPole_; }

  Result<std::unique_ptr<NodeSource>> open(const NodeLattice& lattice) const override {
    Result<std::unique_ptr<RasterSampler>> sampler =
        RasterSampler::open(setup_, lattice, setup_->resampling, true);
    if (!sampler.ok())
      return sampler.status();
    return std::unique_ptr<NodeSource>(*std::move(sampler));
  }

  void enterThread() const override { setup_->input.access.enterThread(); }

  Result<bool> hasData() const override { return RasterSampler::anyHeight(setup_->input); }

  /// A block is held twice while it is read: as it is in the file and in the block cache.
  std::size_t bytesPerSource() const override {
    return RasterSampler::bytes() + kDatasetBytes + 2 * setup_->input.blockBytes;
  }

  /// Reads both pole rows: the mean of 1024 bilinear samples.
  Status readPoles() {
    const NodeLattice lattice(Scheme(Profile::geodetic), 2, 128);
    const Result<std::unique_ptr<RasterSampler>> sampler =
        RasterSampler::open(setup_, lattice, Resampling::bilinear, false);
    if (!sampler.ok())
      return sampler.status();
    std::vector<float> row(std::size_t(lattice.columns()));
    for (bool north : {false, true}) {
      QMESH_RETURN_IF_ERROR((*sampler)->sample(0, north ? lattice.lastRow() : 0, int(row.size()), 1,
                                               row.data(), std::ptrdiff_t(row.size())));
      double sum = 0;
      int count = 0;
      for (float height : row)
        if (height == height) {
          sum += height;
          ++count;
        }
      (north ? northPole_ : southPole_) =
          count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
    }
    return {};
  }

 private:
  std::shared_ptr<const SamplerSetup> setup_;
  std::vector<GeoBox> extent_;
  double northPole_ = std::numeric_limits<double>::quiet_NaN();
  double southPole_ = std::numeric_limits<double>::quiet_NaN();
};

/// Reads --te and --cutline and crops `extent` to them.
Status addRegions(const InputOptions& options, SamplerSetup& setup, std::vector<GeoBox>& extent) {
  const auto add = [&](Result<Region> region, const std::string& name) -> Status {
    if (!region.ok())
      return region.status();
    extent = cropped(extent, *region);
    if (extent.empty())
      return {Code::input, name + " does not meet the data of '" + options.path + "'"};
    setup.regions.push_back(*std::move(region));
    return {};
  };
  if (options.extent)
    QMESH_RETURN_IF_ERROR(add(readExtent(options, setup.input.srs), "--te"));
  if (!options.cutline.empty())
    QMESH_RETURN_IF_ERROR(add(readCutline(options.cutline, setup.input.srs),
                              "the cutline '" + options.cutline + "'"));
  return {};
}

} // namespace

Result<std::shared_ptr<NodeSourceFactory>> openRasterSource(const InputOptions& options,
                                                            const HeightOptions& heights,
                                                            std::vector<std::string>& warnings,
                                                            GDALDataset* host) {
  Result<RasterInput> input = describeRaster(options, heights.bathymetry, host, warnings);
  if (!input.ok())
    return input.status();
  auto setup = std::make_shared<SamplerSetup>();
  setup->input = *std::move(input);
  setup->resampling = options.resampling;
  setup->heights.scaleAbove = heights.scaleAbove;
  setup->heights.scaleBelow = heights.scaleBelow;
  setup->heights.clipLow = heights.clipLow;
  setup->heights.clipHigh = heights.clipHigh;
  const Result<GeoBox> whole = rasterExtent(setup->input);
  if (!whole.ok())
    return whole.status();
  setup->extent = widened(*whole);
  Result<std::vector<GeoBox>> extent = coverageExtent(setup->input);
  if (!extent.ok())
    return extent.status();
  QMESH_RETURN_IF_ERROR(addRegions(options, *setup, *extent));
  auto factory = std::make_shared<RasterSourceFactory>(setup, *std::move(extent));
  QMESH_RETURN_IF_ERROR(factory->readPoles());
  return std::shared_ptr<NodeSourceFactory>(factory);
}

} // namespace qmesh
