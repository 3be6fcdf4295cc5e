// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace qmesh {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kLanczosRadius = 3;

double sinc(double x) {
  return x == 0 ? 1 : std::sin(kPi * x) / (kPi * x);
}

/// Lanczos weights are read from a table (linear between entries, error below 1e-6): two sines per
/// pixel would cost more than everything else.
class LanczosTable {
 public:
  LanczosTable() {
    for (int k = 0; k <= kEntries; ++k) {
      const double x = double(k) / kPerUnit;
      entry_[std::size_t(k)] = k < kEntries ? sinc(x) * sinc(x / kLanczosRadius) : 0;
    }
  }
  double operator()(double x) const {
    const double at = x * kPerUnit;
    const int k = int(at);
    if (k >= kEntries)
      return 0;
    const double a = entry_[std::size_t(k)];
    return a + (entry_[std::size_t(k) + 1] - a) * (at - k);
  }

 private:
  static constexpr int kPerUnit = 2048;
  static constexpr int kEntries = kPerUnit * kLanczosRadius;
  std::array<double, kEntries + 1> entry_;
};

double keys(double x) {
  if (x < 1)
    return (1.5 * x - 2.5) * x * x + 1;
  return x < 2 ? ((-0.5 * x + 2.5) * x - 4) * x + 2 : 0;
}

double bSpline(double x) {
  if (x < 1)
    return (0.5 * x - 1) * x * x + 2.0 / 3;
  return x < 2 ? (2 - x) * (2 - x) * (2 - x) / 6 : 0;
}

double baseRadius(Resampling resampling) {
  switch (resampling) {
  case Resampling::cubic:
  case Resampling::cubicspline:
    return 2;
  case Resampling::lanczos:
    return kLanczosRadius;
  default:
    return 1;
  }
}

} // namespace

Kernel::Kernel(Resampling resampling, double scale)
    : resampling_(resampling), scale_(scale),
      radius_(resampling == Resampling::average ? (scale + 1) / 2 : baseRadius(resampling) * scale),
      negative_(resampling == Resampling::cubic || resampling == Resampling::lanczos) {}

/// Sets the weights of the taps from a kernel of the distance in stretched pixels; returns their
/// sum.
template <class Weight> double Kernel::fill(double centre, Taps& out, const Weight& weight) const {
  const double perPixel = 1 / scale_;
  double sum = 0;
  for (int k = 0; k < out.count; ++k) {
    const double w = weight(std::abs(out.first + k - centre) * perPixel);
    out.weight[std::size_t(k)] = w;
    sum += w;
  }
  return sum;
}

double Kernel::fill(double centre, Taps& out) const {
  static const LanczosTable lanczos;
  switch (resampling_) {
  case Resampling::cubic:
    return fill(centre, out, keys);
  case Resampling::cubicspline:
    return fill(centre, out, bSpline);
  case Resampling::lanczos:
    return fill(centre, out, lanczos);
  default:
    return fill(centre, out, [](double x) { return std::max(0.0, 1 - x); });
  }
}

void Kernel::taps(double position, Taps& out) const {
  if (resampling_ == Resampling::average) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    boxTaps(position, scale_, -kFar, kFar, out);
    for (double& w : out.weight)
      w /= scale_;
    return;
  }
  const double centre = position - 0.5;
  out.first = int(std::ceil(centre - radius_));
  out.count = int(std::floor(centre + radius_)) - out.first + 1;
  out.weight.resize(std::size_t(out.count));
  const double perSum = 1 / fill(centre, out);
  double moment = 0;
  for (int k = 0; k < out.count; ++k) {
    out.weight[std::size_t(k)] *= perSum;
    moment += out.weight[std::size_t(k)] * (out.first + k - centre);
  }
  // A stretched kernel's centre of gravity misses the node by up to 1/50 pixel. Moved between the
  // two pixels beside the node, that makes planes come back exactly.
  const int left = int(std::floor(centre)) - out.first;
  if (left >= 0 && left + 1 < out.count) {
    out.weight[std::size_t(left)] += moment;
    out.weight[std::size_t(left) + 1] -= moment;
  }
}

void boxTaps(double position, double scale, double low, double high, Taps& out) {
  const double from = std::max(low, position - scale / 2);
  const double to = std::min(high, position + scale / 2);
  out.first = int(std::floor(from));
  out.count = std::max(0, int(std::ceil(to)) - out.first);
  out.weight.resize(std::size_t(out.count));
  for (int k = 0; k < out.count; ++k)
    out.weight[std::size_t(k)] =
        std::min(to, double(out.first + k + 1)) - std::max(from, double(out.first + k));
}

} // namespace qmesh
