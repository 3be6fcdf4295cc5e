// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace qmesh {

/// A parameter that may differ per zoom, in the language all of them share:
///   V                    the same at all zooms
///   V/2^z  V*2^z         from the value at zoom 0
///   a,b,c                zoom 0, 1, 2; the last repeats
///   0:V,3-7:V,8-:V       by zoom or range of zooms; each V may be a formula
/// Numbers are finite and >= 0, zooms 0..24; blanks around pieces do not count. A list takes plain
/// numbers, ranges may not overlap, and zooms they leave out have no value.
class LevelSpec {
 public:
  /// Code::usage with the place of the fault where `text` is malformed.
  static Result<LevelSpec> parse(const std::string& text);

  /// The value at a zoom, or Code::usage when a range leaves that zoom out.
  Result<double> at(int zoom) const;

 private:
  struct Term {
    int first = 0;
    int last = 0; ///< kDeepestZoom when open
    double value = 0;
    int exponent = 0; ///< value * 2^(exponent * z)
  };

  static Result<Term> parseValue(std::string_view text);
  static Status parseRange(std::string_view text, Term& term);
  Status addRanges(const std::vector<std::string_view>& pieces);
  Status addList(const std::vector<std::string_view>& pieces);

  std::vector<Term> terms_;
};

/// The value at a zoom of an option that need not be set: nullopt where `text` is empty.
Result<std::optional<double>> specValue(const std::string& text, int zoom);

} // namespace qmesh
