// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/interpolator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace qmesh {
namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
/// Pixels by which a node may miss a pixel's square and still lie on its rim.
constexpr double kRim = 1e-6;

constexpr int kBatch = 64;

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

/// The hot path, in batches so that the compiler can use vectors: where the window holds four
/// pixels round every node no test is needed. Nodes it cannot serve go to bilinear(); which they
/// are depends on their pixels alone, since the window holds all that exist.
void Interpolator::runBilinear(const double* x, const double* y, int count, float* out) const {
  for (int first = 0; first < count; first += kBatch) {
    const int n = std::min(kBatch, count - first);
    const double* bx = x + first;
    const double* by = y + first;
    float* heights = out + first;
    if (allSurrounded_) {
      fourPixels(bx, by, n, heights);
    } else {
      for (int k = 0; k < n; ++k) {
        heights[k] = kVoid;
        if (surrounded(bx[k], by[k]))
          fourPixels(bx + k, by + k, 1, heights + k);
      }
    }
    for (int k = 0; k < n; ++k)
      if (isVoid(heights[k]))
        heights[k] = bilinear(bx[k], by[k]);
  }
}

/// True where the window holds the four pixels round a position, columns from 0 on.
bool Interpolator::surrounded(double x, double y) const {
  const PixelWindow& p = *pixels_;
  return x >= std::max(p.column, 0) + 0.5 && x < p.column + p.width - 0.5 && y >= p.row + 0.5 &&
         y < p.row + p.height - 0.5;
}

/// REQUIRES: surrounded(), count <= kBatch.
void Interpolator::fourPixels(const double* x, const double* y, int count, float* out) const {
  const PixelWindow& p = *pixels_;
  std::array<int, kBatch> column, row;
  std::array<float, kBatch> fx, fy;
  for (int k = 0; k < count; ++k) {
    const double u = x[k] - 0.5;
    const double v = y[k] - 0.5;
    column[k] = int(u);
    row[k] = int(v);
    fx[k] = float(u - column[k]);
    fy[k] = float(v - row[k]);
  }
  for (int k = 0; k < count; ++k) {
    const float* a = &p.data[std::size_t(row[k] - p.row) * std::size_t(p.width) +
                             std::size_t(column[k] - p.column)];
    const float top = a[0] + (a[1] - a[0]) * fx[k];
    const float bottom = a[p.width] + (a[p.width + 1] - a[p.width]) * fx[k];
    out[k] = top + (bottom - top) * fy[k];
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

/// The kernel where all its pixels are valid; else NaN.
float Interpolator::allValid(double x, double y) {
  const PixelWindow& p = *pixels_;
  kernelX_.taps(x, tapsX_);
  if (y != tapsYFor_) { // rows of a geographic raster share it
    kernelY_.taps(y, fullTapsY_);
    tapsYFor_ = y;
  }
  const Taps& rows = fullTapsY_;
  const int c0 = tapsX_.first;
  if (!p.contains(c0, rows.first) ||
      !p.contains(c0 + tapsX_.count - 1, rows.first + rows.count - 1))
    return kVoid;
  const auto columns = std::size_t(tapsX_.count);
  const float* line =
      &p.data[std::size_t(rows.first - p.row) * std::size_t(p.width) + std::size_t(c0 - p.column)];
  columnSums_.assign(columns, 0);
  for (int r = 0; r < rows.count; ++r, line += p.width) {
    const double weight = rows.weight[std::size_t(r)];
    for (std::size_t c = 0; c < columns; ++c)
      columnSums_[c] += weight * double(line[c]);
  }
  double sum = 0;
  for (std::size_t c = 0; c < columns; ++c)
    sum += tapsX_.weight[c] * columnSums_[c];
  return float(sum);
}

float Interpolator::general(double x, double y) {
  const float full = allValid(x, y);
  if (!isVoid(full))
    return full;
  if (reducing_ ? !halfValid(x, y) : isVoid(byPixel(x, y)))
    return kVoid;
  double validWeight = 0;
  const float height = weighted(kernelX_, kernelY_, x, y, validWeight);
  if (!kernelX_.hasNegativeLobes() || validWeight >= 0.5)
    return height;
  return weighted(tentX_, tentY_, x, y, validWeight);
}

void Interpolator::use(const PixelWindow& pixels, const PixelBounds& bounds) {
  pixels_ = &pixels;
  // A hundredth of a pixel for the rounding of the bounds.
  allSurrounded_ = bounds.complete && surrounded(bounds.west - 0.01, bounds.north - 0.01) &&
                   surrounded(bounds.east + 0.01, bounds.south + 0.01);
}

void Interpolator::run(const double* x, const double* y, int count, float* out) {
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
