// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/raster_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "source/crs.h"
#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
/// Nodes are sampled in parts of at most so many columns and rows, cut at global multiples.
constexpr int kPartColumns = 512;
constexpr int kPartRows = 64;
/// Pixels kept for a part; a part that needs more is halved.
constexpr std::int64_t kWindowPixels = 2 << 20;
/// Node spacings below this many pixels are not worth a wider kernel.
constexpr double kSameSpacing = 1.01;

using Scale = std::array<double, 2>; ///< node spacing in pixels, in x and y

Result<std::unique_ptr<NodePositions>>
makePositions(const SamplerSetup& setup, const NodeLattice& lattice, const PixelFrame& frame) {
  if (setup.input.lonLat)
    return makeAffinePositions(lattice, frame);
  return makeTransformedPositions(lattice, frame, setup.input.srs, setup.extent, setup.input.path);
}

/// Node spacing at the middle of the raster, 1 where it cannot be told.
Result<Scale> spacingInPixels(const SamplerSetup& setup, const NodeLattice& lattice) {
  const PixelFrame& frame = setup.input.frame;
  const Result<PointTransform> transform =
      PointTransform::create(setup.input.srs, lonLatSrs(), setup.input.path);
  if (!transform.ok())
    return transform.status();
  const Result<PointTransform> back =
      PointTransform::create(lonLatSrs(), setup.input.srs, setup.input.path);
  if (!back.ok())
    return back.status();
  double lon = 0;
  double lat = 0;
  frame.toPlace(frame.width / 2, frame.height / 2, lon, lat);
  if (!transform->apply(lon, lat))
    return Scale{1, 1};
  const Scheme& scheme = lattice.scheme();
  const double stepX = lattice.spacingDegrees();
  const double y = std::clamp(scheme.fractionY(lat) * double(lattice.lastRow()), 0.5,
                              double(lattice.lastRow()) - 0.5);
  const auto row = std::int64_t(y - 0.5);
  const double south = lattice.latitude(row);
  const double north = lattice.latitude(row + 1);
  const auto pixel = [&](double x, double latitude, double& column, double& line) {
    return back->apply(x, latitude) && (frame.toPixel(x, latitude, column, line), true);
  };
  const double middle = (south + north) / 2;
  std::array<double, 4> c{};
  std::array<double, 4> r{};
  if (!pixel(lon - stepX / 2, middle, c[0], r[0]) || !pixel(lon + stepX / 2, middle, c[1], r[1]) ||
      !pixel(lon, south, c[2], r[2]) || !pixel(lon, north, c[3], r[3]))
    return Scale{1, 1};
  const Scale spacing{std::hypot(c[1] - c[0], c[3] - c[2]), std::hypot(r[1] - r[0], r[3] - r[2])};
  return Scale{spacing[0] < kSameSpacing ? 1 : spacing[0],
               spacing[1] < kSameSpacing ? 1 : spacing[1]};
}

} // namespace

float HeightRules::apply(float height) const {
  if (height != height)
    return height;
  double out = height * (height < 0 ? scaleBelow : scaleAbove);
  if (clipLow)
    out = std::max(out, *clipLow);
  if (clipHigh)
    out = std::min(out, *clipHigh);
  return float(out);
}

Result<std::unique_ptr<RasterSampler>>
RasterSampler::open(std::shared_ptr<const SamplerSetup> setup, const NodeLattice& lattice,
                    Resampling resampling, bool antialias) {
  QuietErrors errors;
  const RasterInput& input = setup->input;
  Result<DatasetPtr> dataset = input.access.open();
  if (!dataset.ok())
    return dataset.status();
  const std::unique_lock<std::mutex> lock = lockOf(input.access.mutex());
  GDALDataset& opened = **dataset;
  if (opened.GetRasterCount() < input.band || opened.GetRasterXSize() != int(input.frame.width) ||
      opened.GetRasterYSize() != int(input.frame.height))
    return Status(Code::input, "'" + input.path + "' changed while it was read");
  GDALRasterBand& band = *opened.GetRasterBand(input.band);
  Scale scale{1, 1};
  PixelLevel level = PixelLevel::full(input.frame);
  if (antialias && resampling != Resampling::nearest) {
    const Result<Scale> spacing = spacingInPixels(*setup, lattice);
    if (!spacing.ok())
      return spacing.status();
    level = PixelLevel::choose(band, input.frame, (*spacing)[0], (*spacing)[1]);
    scale = {std::max(1.0, (*spacing)[0] / level.factorX),
             std::max(1.0, (*spacing)[1] / level.factorY)};
  }
  const PixelFrame frame = input.frame.reduced(level.factorX, level.factorY);
  Result<std::unique_ptr<NodePositions>> positions = makePositions(*setup, lattice, frame);
  if (!positions.ok())
    return positions.status();
  PixelReader reader(band, input, level, frame.period);
  return std::unique_ptr<RasterSampler>(new RasterSampler(
      setup, lattice, *std::move(dataset), *std::move(positions), std::move(reader),
      Interpolator(resampling, scale[0], scale[1], frame), frame));
}

RasterSampler::RasterSampler(std::shared_ptr<const SamplerSetup> setup, const NodeLattice& lattice,
                             DatasetPtr dataset, std::unique_ptr<NodePositions> positions,
                             PixelReader reader, Interpolator interpolator, const PixelFrame& frame)
    : setup_(std::move(setup)), lattice_(lattice), dataset_(std::move(dataset)),
      positions_(std::move(positions)), reader_(std::move(reader)),
      interpolator_(std::move(interpolator)), frame_(frame), x_(kPartColumns * kPartRows),
      y_(kPartColumns * kPartRows), longitudes_(kPartColumns) {}

Result<bool> RasterSampler::anyHeight(const RasterInput& input) {
  QuietErrors errors;
  const Result<DatasetPtr> dataset = input.access.open();
  if (!dataset.ok())
    return dataset.status();
  PixelReader reader(*(*dataset)->GetRasterBand(input.band), input, PixelLevel::full(input.frame),
                     0);
  constexpr int kSide = 1024;
  const int columns = int(input.frame.width);
  const int rows = int(input.frame.height);
  PixelWindow window;
  for (window.row = 0; window.row < rows; window.row += kSide)
    for (window.column = 0; window.column < columns; window.column += kSide) {
      window.width = std::min(kSide, columns - window.column);
      window.height = std::min(kSide, rows - window.row);
      QMESH_RETURN_IF_ERROR(reader.read(window));
      if (std::any_of(window.data.begin(), window.data.end(), [](float h) { return h == h; }))
        return true;
    }
  return false;
}

std::size_t RasterSampler::bytes() {
  return std::size_t(kWindowPixels) * sizeof(float) + PixelReader::scratchBytes() +
         std::size_t(2 * kPartColumns * kPartRows) * sizeof(double);
}

Status RasterSampler::sample(std::int64_t i0, std::int64_t j0, int width, int height, float* out,
                             std::ptrdiff_t stride) {
  QuietErrors errors;
  const std::int64_t columns = lattice_.columns();
  for (int b = 0; b < height;) {
    const std::int64_t j = j0 + b;
    const int rows = std::min(height - b, kPartRows - int(j % kPartRows));
    for (int a = 0; a < width;) {
      const std::int64_t i = lattice_.wrap(i0 + a);
      const int part =
          int(std::min<std::int64_t>({width - a, columns - i, kPartColumns - i % kPartColumns}));
      QMESH_RETURN_IF_ERROR(sampleWindow({i, j, part, rows}, out + b * stride + a, stride));
      a += part;
    }
    b += rows;
  }
  return {};
}

/// The pixels that nodes within `bounds` need, cut to the raster; false where there are none.
bool RasterSampler::pixelRectangle(const PixelBounds& bounds, PixelWindow& pixels) const {
  if (bounds.empty())
    return false;
  const double columns = std::ceil(frame_.width);
  const double rows = std::ceil(frame_.height);
  double west = bounds.west - interpolator_.radiusX();
  double east = bounds.east + interpolator_.radiusX();
  if (frame_.period == 0) {
    west = std::max(west, 0.0);
    east = std::min(east, columns);
  }
  const double north = std::max(bounds.north - interpolator_.radiusY(), 0.0);
  const double south = std::min(bounds.south + interpolator_.radiusY(), rows);
  if (!(west < east && north < south))
    return false;
  pixels.column = int(std::floor(west));
  pixels.row = int(std::floor(north));
  pixels.width = int(std::ceil(east)) - pixels.column;
  pixels.height = int(std::ceil(south)) - pixels.row;
  return true;
}

Status RasterSampler::sampleWindow(const NodeRectangle& window, float* out, std::ptrdiff_t stride) {
  const PixelBounds bounds = positions_->fill(window, x_.data(), y_.data());
  if (!pixelRectangle(bounds, pixels_)) {
    for (int b = 0; b < window.height; ++b)
      std::fill(out + b * stride, out + b * stride + window.width, kVoid);
    return {};
  }
  const bool single = window.width == 1 && window.height == 1;
  if (!single && std::int64_t(pixels_.width) * pixels_.height > kWindowPixels) {
    const bool wide = window.width >= window.height;
    NodeRectangle first = window;
    (wide ? first.width : first.height) /= 2;
    NodeRectangle second = window;
    (wide ? second.i : second.j) += wide ? first.width : first.height;
    (wide ? second.width : second.height) -= wide ? first.width : first.height;
    QMESH_RETURN_IF_ERROR(sampleWindow(first, out, stride));
    return sampleWindow(second, out + (wide ? first.width : first.height * stride), stride);
  }
  QMESH_RETURN_IF_ERROR(reader_.read(pixels_));
  interpolator_.use(pixels_, bounds);
  for (int b = 0; b < window.height; ++b) {
    const std::ptrdiff_t line = std::ptrdiff_t(b) * window.width;
    interpolator_.run(x_.data() + line, y_.data() + line, window.width, out + b * stride);
    finishRow(window, b, out + b * stride);
  }
  return {};
}

void RasterSampler::finishRow(const NodeRectangle& window, int row, float* heights) {
  if (!setup_->heights.none())
    for (int a = 0; a < window.width; ++a)
      heights[a] = setup_->heights.apply(heights[a]);
  if (setup_->regions.empty())
    return;
  for (int a = 0; a < window.width; ++a)
    longitudes_[std::size_t(a)] = lattice_.longitude(window.i + a);
  for (const Region& region : setup_->regions)
    region.clearOutside(lattice_.latitude(window.j + row), longitudes_.data(), window.width,
                        heights);
}

} // namespace qmesh
