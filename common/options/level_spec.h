// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/status.h"

namespace qmesh {

/// A parameter that may differ per zoom, in the language all of them share:
///   V                    the same at all zooms
///   V/2^z  V*2^z         from the value at zoom 0
///   a,b,c                zoom 0, 1, 2; the last repeats
///   0:V,3-7:V,8-:V       by zoom or range of zooms; each V may be a formula
/// Numbers are finite and >= 0.
class LevelSpec {
 public:
  /// Code::usage with the place of the fault where `text` is malformed.
  static Result<LevelSpec> parse(const std::string& text);

  /// The value at a zoom, or Code::usage when a range leaves that zoom out.
  Result<double> at(int zoom) const;

 private:
  struct Term {
    int first = 0;
    int last = 0;      ///< kMaxZoom when open
    double value = 0;
    int exponent = 0;  ///< value * 2^(exponent * z)
  };
  std::vector<Term> terms_;
};

}  // namespace qmesh
