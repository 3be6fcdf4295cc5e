// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "base/enum_table.h"

namespace qmesh {

/// How a height is found between the cells of a raster.
enum class Resampling { nearest, bilinear, cubic, cubicspline, lanczos, average };

template <> struct EnumTable<Resampling> {
  static constexpr EnumRow<Resampling> kRows[] = {
      {Resampling::nearest, "nearest", "the height of the nearest cell"},
      {Resampling::bilinear, "bilinear", "linear between 2 x 2 cells"},
      {Resampling::cubic, "cubic", "cubic convolution of 4 x 4 cells"},
      {Resampling::cubicspline, "cubicspline", "cubic B-spline of 4 x 4 cells, smooths"},
      {Resampling::lanczos, "lanczos", "windowed sinc of 6 x 6 cells"},
      {Resampling::average, "average", "mean of the cells around a node"},
      {Resampling::nearest, "near"},
  };
};

/// A row of weights for the pixels first..first+count-1.
struct Taps {
  int first = 0;
  int count = 0;
  std::vector<double> weight;
};

/// One dimension of a resampling kernel, stretched by a fixed scale (>= 1) so that reducing does
/// not alias. bilinear: tent; cubic: Keys 1981, a = -1/2; cubicspline: the cubic B-spline; lanczos:
/// radius 3; average: box with partial pixels. `nearest` has no kernel.
class Kernel {
 public:
  Kernel(Resampling resampling, double scale);

  /// Pixels beyond which a weight is zero.
  double radius() const { return radius_; }
  bool hasNegativeLobes() const { return negative_; }

  /// Weights of the pixels around a position in pixel space; their sum is 1 and, but for `average`,
  /// their centre of gravity is the position.
  void taps(double position, Taps& out) const;

 private:
  template <class Weight> double fill(double centre, Taps& out, const Weight& weight) const;
  double fill(double centre, Taps& out) const;

  Resampling resampling_;
  double scale_;
  double radius_;
  bool negative_;
};

/// The length that each pixel has in the interval position - scale/2 .. position + scale/2, cut to
/// low..high; not normalised.
void boxTaps(double position, double scale, double low, double high, Taps& out);

} // namespace qmesh
