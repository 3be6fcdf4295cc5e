// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/level_spec.h"

#include <cmath>

#include "base/text.h"

namespace qmesh {

namespace {

Status fault(std::string_view piece, const std::string& cure) {
  return Status(Code::usage, "'" + std::string(piece) + "': " + cure);
}

/// A zoom of a range, -1 where `text` is none.
int parseZoom(std::string_view text) {
  const auto zoom = parseInteger(text);
  return zoom && *zoom >= 0 && *zoom <= kMaxZoom ? static_cast<int>(*zoom) : -1;
}

/// Cuts a trailing "/2^z" or "*2^z" off `text` and returns its exponent per zoom: -1, 1, or 0.
int takeFormula(std::string_view& text) {
  constexpr std::string_view kPower = "2^z";
  const std::size_t size = text.size();
  if (size < kPower.size() || text.substr(size - kPower.size()) != kPower)
    return 0;
  const std::string_view head = trimmed(text.substr(0, size - kPower.size()));
  if (head.empty() || (head.back() != '/' && head.back() != '*'))
    return 0;
  text = trimmed(head.substr(0, head.size() - 1));
  return head.back() == '/' ? -1 : 1;
}

} // namespace

LevelSpec::LevelSpec(double value) : text_(formatNumber(value)) {
  Term term;
  term.last = kMaxZoom;
  term.value = value;
  terms_.push_back(term);
}

Result<LevelSpec::Term> LevelSpec::parseValue(std::string_view text) {
  std::string_view number = text;
  Term term;
  term.exponent = takeFormula(number);
  const auto value = parseNumber(number);
  if (!value)
    return fault(text, "expected a number, NUMBER/2^z or NUMBER*2^z");
  if (!(*value >= 0))
    return fault(text, "the number must be 0 or more");
  if (!std::isfinite(std::ldexp(*value, kMaxZoom)))
    return fault(text, "too large");
  term.value = *value;
  return term;
}

Status LevelSpec::parseRange(std::string_view text, Term& term) {
  const std::size_t dash = text.find('-');
  const std::string_view first = trimmed(text.substr(0, dash));
  const std::string_view last =
      dash == std::string_view::npos ? first : trimmed(text.substr(dash + 1));
  term.first = parseZoom(first);
  term.last = last.empty() ? kMaxZoom : parseZoom(last);
  if (first.empty() || term.first < 0 || term.last < 0)
    return fault(text, "expected a zoom or a range of zooms (3, 3-7 or 8-) from 0 to " +
                           std::to_string(kMaxZoom));
  if (term.first > term.last)
    return fault(text, "the range ends before it begins");
  return {};
}

Status LevelSpec::addRanges(const std::vector<std::string_view>& pieces) {
  for (const std::string_view piece : pieces) {
    const std::size_t colon = piece.find(':');
    if (colon == std::string_view::npos)
      return fault(piece, "either every piece has its zooms (0:V,3-7:V) or none has");
    Result<Term> term = parseValue(trimmed(piece.substr(colon + 1)));
    if (!term.ok())
      return term.status();
    QMESH_RETURN_IF_ERROR(parseRange(trimmed(piece.substr(0, colon)), *term));
    for (const Term& other : terms_)
      if (term->first <= other.last && other.first <= term->last)
        return fault(piece, "a piece before it has some of these zooms already");
    terms_.push_back(*term);
  }
  return {};
}

Status LevelSpec::addList(const std::vector<std::string_view>& pieces) {
  if (pieces.size() > kMaxZoom + 1u)
    return fault(pieces.back(), "more values than there are zooms");
  for (const std::string_view piece : pieces) {
    Result<Term> term = parseValue(piece);
    if (!term.ok())
      return term.status();
    if (term->exponent != 0 && pieces.size() > 1)
      return fault(piece, "a formula in a list needs its zooms (0-4:V,5-:V)");
    term->first = static_cast<int>(terms_.size());
    term->last = terms_.size() + 1 == pieces.size() ? kMaxZoom : term->first;
    terms_.push_back(*term);
  }
  return {};
}

Result<LevelSpec> LevelSpec::parse(const std::string& text) {
  std::vector<std::string_view> pieces = split(text, ',');
  for (std::string_view& piece : pieces)
    piece = trimmed(piece);
  LevelSpec spec;
  spec.text_ = text;
  const bool ranges = text.find(':') != std::string::npos;
  QMESH_RETURN_IF_ERROR(ranges ? spec.addRanges(pieces) : spec.addList(pieces));
  return spec;
}

Result<double> LevelSpec::at(int zoom) const {
  for (const Term& term : terms_)
    if (zoom >= term.first && zoom <= term.last)
      return std::ldexp(term.value, term.exponent * zoom);
  return Status(Code::usage, "no value for zoom " + std::to_string(zoom) +
                                 "; add it, for example as '" + std::to_string(zoom) + "-:V'");
}

Result<std::optional<double>> LevelSpec::find(int zoom) const {
  if (!isSet())
    return std::optional<double>();
  const Result<double> value = at(zoom);
  if (!value.ok())
    return value.status();
  return std::optional<double>(*value);
}

double LevelSpec::valueOr(int zoom, double otherwise) const {
  const Result<double> value = at(zoom);
  return value.ok() ? *value : otherwise;
}

} // namespace qmesh
