// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "tiling/scheme.h"

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
  /// Not set: has no value at any zoom, and no text.
  LevelSpec() = default;
  /// The same value, finite and >= 0, at all zooms.
  explicit LevelSpec(double value);
  /// Code::usage with the place of the fault where `text` is malformed.
  static Result<LevelSpec> parse(const std::string& text);

  bool isSet() const { return !terms_.empty(); }
  /// As it was parsed; empty where it is not set.
  const std::string& text() const { return text_; }

  /// The value at a zoom, or Code::usage when a range leaves that zoom out.
  Result<double> at(int zoom) const;
  /// The same; nothing where it is not set.
  Result<std::optional<double>> find(int zoom) const;
  /// The value at a zoom; `otherwise` where it has none.
  double valueOr(int zoom, double otherwise) const;

 private:
  struct Term {
    int first = 0;
    int last = 0; ///< kMaxZoom when open
    double value = 0;
    int exponent = 0; ///< value * 2^(exponent * z)
  };

  static Result<Term> parseValue(std::string_view text);
  static Status parseRange(std::string_view text, Term& term);
  Status addRanges(const std::vector<std::string_view>& pieces);
  Status addList(const std::vector<std::string_view>& pieces);

  std::string text_;
  std::vector<Term> terms_;
};

} // namespace qmesh
