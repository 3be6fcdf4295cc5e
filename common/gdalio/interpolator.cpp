// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "gdalio/interpolator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qmesh {
namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
/// Pixels by which a node may miss a pixel's square and still lie on its rim.
constexpr double kRim = 1e-6;

bool isVoid(double value) {
  return value != value;
}

/// The pixel whose square holds a position in one dimension, and on its rim the one next to it.
struct Holders {
  int own;
  int other;
};

Holders holders(double position) {
  const int own = int(std::floor(position));
  const double within = position - own;
  if (within <= kRim)
    return {own, own - 1};
  return {own, within >= 1 - kRim ? own + 1 : own};
}

} // namespace

Interpolator::Interpolator(Resampling resampling, double scaleX, double scaleY,
                           const PixelFrame& frame)
    : resampling_(resampling),
      reducing_(resampling != Resampling::nearest && (scaleX > 1 || scaleY > 1)), scaleX_(scaleX),
      scaleY_(scaleY), frame_(frame), kernelX_(resampling, scaleX), kernelY_(resampling, scaleY),
      tentX_(Resampling::bilinear, scaleX), tentY_(Resampling::bilinear, scaleY),
      radiusX_(std::max(kernelX_.radius(), tentX_.radius()) + 1),
      radiusY_(std::max(kernelY_.radius(), tentY_.radius()) + 1) {}

float Interpolator::pixel(int column, int row) const {
  return pixels_->contains(column, row) ? pixels_->at(column, row) : kVoid;
}

/// False for NaN as well.
bool Interpolator::insideRaster(double x, double y) const {
  const bool column = frame_.period > 0 ? !isVoid(x) : x >= -kRim && x <= frame_.width + kRim;
  return column && y >= -kRim && y <= frame_.height + kRim;
}

float Interpolator::byPixel(double x, double y) const {
  const Holders columns = holders(x);
  const Holders rows = holders(y);
  for (int r : {rows.own, rows.other})
    for (int c : {columns.own, columns.other}) {
      const float value = pixel(c, r);
      if (!isVoid(value))
        return value;
    }
  return kVoid;
}

float Interpolator::bilinear(double x, double y) const {
  if (!insideRaster(x, y) || isVoid(byPixel(x, y)))
    return kVoid;
  const int c = int(std::floor(x - 0.5));
  const int r = int(std::floor(y - 0.5));
  const double u = x - 0.5 - c;
  const double v = y - 0.5 - r;
  double sum = 0;
  double total = 0;
  for (int k = 0; k < 4; ++k) {
    const double value = pixel(c + k % 2, r + k / 2);
    const double weight = (k % 2 ? u : 1 - u) * (k / 2 ? v : 1 - v);
    if (!isVoid(value)) {
      sum += weight * value;
      total += weight;
    }
  }
  return float(sum / total);
}

/// The hot path: four valid pixels around the node. All others go to bilinear().
void Interpolator::runBilinear(const double* x, const double* y, int count, float* out) const {
  const PixelWindow& p = *pixels_;
  const double west = std::max(p.column, 0);
  const double north = p.row;
  const double east = p.column + p.width - 1;
  const double south = p.row + p.height - 1;
  const float* origin =
      p.data.data() - (std::ptrdiff_t(p.row) * p.width + std::ptrdiff_t(p.column));
  for (int k = 0; k < count; ++k) {
    const double u = x[k] - 0.5;
    const double v = y[k] - 0.5;
    float height = kVoid;
    if (u >= west && u < east && v >= north && v < south) {
      const int c = int(u);
      const int r = int(v);
      const double fx = u - c;
      const double fy = v - r;
      const float* a = origin + std::ptrdiff_t(r) * p.width + c;
      const double top = a[0] + (double(a[1]) - double(a[0])) * fx;
      const double bottom = a[p.width] + (double(a[p.width + 1]) - double(a[p.width])) * fx;
      height = float(top + (bottom - top) * fy);
    }
    out[k] = isVoid(height) ? bilinear(x[k], y[k]) : height;
  }
}

bool Interpolator::halfValid(double x, double y) {
  const bool round = frame_.period > 0;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  boxTaps(x, scaleX_, round ? -kFar : 0, round ? kFar : frame_.width, tapsX_);
  boxTaps(y, scaleY_, 0, frame_.height, tapsY_);
  double valid = 0;
  double all = 0;
  for (int r = 0; r < tapsY_.count; ++r)
    for (int c = 0; c < tapsX_.count; ++c) {
      const double area = tapsX_.weight[std::size_t(c)] * tapsY_.weight[std::size_t(r)];
      all += area;
      if (!isVoid(pixel(tapsX_.first + c, tapsY_.first + r)))
        valid += area;
    }
  return valid > 0 && valid >= all * (0.5 - kRim);
}

float Interpolator::weighted(const Kernel& kernelX, const Kernel& kernelY, double x, double y,
                             double& validWeight) {
  kernelX.taps(x, tapsX_);
  kernelY.taps(y, tapsY_);
  double sum = 0;
  validWeight = 0;
  for (int r = 0; r < tapsY_.count; ++r) {
    double rowSum = 0;
    double rowWeight = 0;
    for (int c = 0; c < tapsX_.count; ++c) {
      const double value = pixel(tapsX_.first + c, tapsY_.first + r);
      const double weight = tapsX_.weight[std::size_t(c)];
      if (!isVoid(value)) {
        rowSum += weight * value;
        rowWeight += weight;
      }
    }
    sum += tapsY_.weight[std::size_t(r)] * rowSum;
    validWeight += tapsY_.weight[std::size_t(r)] * rowWeight;
  }
  return float(sum / validWeight);
}

float Interpolator::general(double x, double y) {
  if (reducing_ ? !halfValid(x, y) : isVoid(byPixel(x, y)))
    return kVoid;
  double validWeight = 0;
  const float height = weighted(kernelX_, kernelY_, x, y, validWeight);
  if (!kernelX_.hasNegativeLobes() || validWeight >= 0.5)
    return height;
  return weighted(tentX_, tentY_, x, y, validWeight);
}

void Interpolator::run(const PixelWindow& pixels, const double* x, const double* y, int count,
                       float* out) {
  pixels_ = &pixels;
  const bool tent = resampling_ == Resampling::bilinear || resampling_ == Resampling::average;
  if (tent && !reducing_) // a box of one pixel gives bilinear weights
    return runBilinear(x, y, count, out);
  for (int k = 0; k < count; ++k) {
    if (!insideRaster(x[k], y[k]))
      out[k] = kVoid;
    else
      out[k] = resampling_ == Resampling::nearest ? byPixel(x[k], y[k]) : general(x[k], y[k]);
  }
}

} // namespace qmesh
