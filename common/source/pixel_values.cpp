// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/pixel_values.h"

#include <cctype>
#include <cmath>
#include <limits>

#include "base/text.h"

namespace qmesh {
namespace {

struct UnitRow {
  const char* name; ///< lower case, without blanks, underscores, hyphens and dots
  double metres;
};

constexpr double kFoot = 0.3048;
constexpr double kSurveyFoot = 1200.0 / 3937.0;

constexpr UnitRow kUnits[] = {
    {"", 1},
    {"m", 1},
    {"metre", 1},
    {"meter", 1},
    {"metres", 1},
    {"meters", 1},
    {"ft", kFoot},
    {"foot", kFoot},
    {"feet", kFoot},
    {"internationalfoot", kFoot},
    {"internationalfeet", kFoot},
    {"footinternational", kFoot},
    {"ussurveyfoot", kSurveyFoot},
    {"ussurveyfeet", kSurveyFoot},
    {"surveyfoot", kSurveyFoot},
    {"surveyfeet", kSurveyFoot},
    {"usft", kSurveyFoot},
    {"ftus", kSurveyFoot},
    {"sft", kSurveyFoot},
    {"footus", kSurveyFoot},
    {"feetus", kSurveyFoot},
    {"usfoot", kSurveyFoot},
    {"usfeet", kSurveyFoot},
    {"yd", 0.9144},
    {"fathom", 1.8288},
    {"fathoms", 1.8288},
    {"km", 1000},
    {"kilometre", 1000},
    {"kilometer", 1000},
    {"dm", 0.1},
    {"decimetre", 0.1},
    {"decimeter", 0.1},
    {"cm", 0.01},
    {"centimetre", 0.01},
    {"centimeter", 0.01},
    {"mm", 0.001},
    {"millimetre", 0.001},
    {"millimeter", 0.001},
};

GDALDataType exactType(GDALDataType type) {
  switch (type) {
  case GDT_UInt32:
  case GDT_Int32:
  case GDT_Float64:
    return GDT_Float64;
  case GDT_Int64:
  case GDT_UInt64:
    return type;
  default:
    return GDT_Float32;
  }
}

/// True where a number of a whole-number type can equal `value`.
template <class T> bool fits(double value) {
  return std::floor(value) == value && value >= double(std::numeric_limits<T>::min()) &&
         value < std::ldexp(1.0, std::numeric_limits<T>::digits);
}

/// Metres. Beyond it a number is a fill value that nobody declared; 64-bit whole numbers end
/// before.
constexpr double kLargestHeight = 1e19;

/// False for NaN and infinities too.
bool isHeight(double metres) {
  return std::abs(metres) <= kLargestHeight;
}
bool isHeight(float metres) {
  return std::abs(metres) <= float(kLargestHeight);
}

} // namespace

std::optional<double> metresPerUnit(const std::string& unit) {
  std::string plain;
  for (char c : unit)
    if (std::string(" _-.()'").find(c) == std::string::npos)
      plain += char(std::tolower(static_cast<unsigned char>(c)));
  for (const UnitRow& row : kUnits)
    if (plain == row.name)
      return row.metres;
  return std::nullopt;
}

PixelValues PixelValues::of(GDALRasterBand& band, std::optional<double> nodata, bool depthsDown,
                            std::vector<std::string>& warnings) {
  PixelValues out;
  out.readType_ = exactType(band.GetRasterDataType());
  const std::string unit = band.GetUnitType();
  const std::optional<double> metres = metresPerUnit(unit);
  if (!metres)
    warnings.push_back("the band's unit '" + unit +
                       "' is not known; its values are taken as metres");
  if (band.GetColorTable())
    warnings.push_back("the band has a palette; its numbers are taken as heights");
  const double unitFactor = metres.value_or(1.0) * (depthsDown ? -1 : 1);
  out.factor_ = band.GetScale() * unitFactor;
  out.shift_ = band.GetOffset() * unitFactor;
  out.setNodata(band, nodata);
  return out;
}

void PixelValues::setNodata(GDALRasterBand& band, std::optional<double> given) {
  int has = FALSE;
  if (readType_ == GDT_Int64 && !given) {
    const std::int64_t value = band.GetNoDataValueAsInt64(&has);
    if (has)
      signedLow_ = signedHigh_ = value;
    return;
  }
  if (readType_ == GDT_UInt64 && !given) {
    const std::uint64_t value = band.GetNoDataValueAsUInt64(&has);
    if (has)
      unsignedLow_ = unsignedHigh_ = value;
    return;
  }
  const double own = given ? 0 : band.GetNoDataValue(&has);
  if (!given && !has)
    return;
  const double value = given.value_or(own);
  if (!std::isfinite(value))
    return; // a void anyway
  if (readType_ == GDT_Int64 && fits<std::int64_t>(value))
    signedLow_ = signedHigh_ = std::int64_t(value);
  else if (readType_ == GDT_UInt64 && fits<std::uint64_t>(value))
    unsignedLow_ = unsignedHigh_ = std::uint64_t(value);
  else if (readType_ == GDT_Float64)
    doubleLow_ = doubleHigh_ = value;
  else if (readType_ == GDT_Float32 &&
           std::abs(value) <= 1.001 * std::numeric_limits<float>::max()) {
    // Texts like -3.4e38 do not name a float32 to the last bit: two neighbours are void as well.
    constexpr float kMost = std::numeric_limits<float>::max();
    const float single = float(std::fmax(-kMost, std::fmin(kMost, value)));
    const bool tolerant = band.GetRasterDataType() == GDT_Float32;
    floatLow_ = floatHigh_ = single;
    for (int k = 0; tolerant && k < 2; ++k) {
      floatLow_ = std::nextafter(floatLow_, -kMost);
      floatHigh_ = std::nextafter(floatHigh_, kMost);
    }
  }
}

template <class T>
void PixelValues::convert(const T* raw, std::size_t count, T low, T high, float* heights) const {
  constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
  if (std::is_same_v<T, float> && factor_ == 1 && shift_ == 0) {
    for (std::size_t k = 0; k < count; ++k)
      heights[k] =
          isHeight(float(raw[k])) && !(raw[k] >= low && raw[k] <= high) ? float(raw[k]) : kVoid;
    return;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const T value = raw[k];
    const bool isVoid = value >= low && value <= high;
    const double height = double(value) * factor_ + shift_;
    heights[k] = isVoid || !isHeight(height) ? kVoid : float(height);
  }
}

void PixelValues::toHeights(const void* raw, std::size_t count, float* heights) const {
  switch (readType_) {
  case GDT_Float64:
    return convert(static_cast<const double*>(raw), count, doubleLow_, doubleHigh_, heights);
  case GDT_Int64:
    return convert(static_cast<const std::int64_t*>(raw), count, signedLow_, signedHigh_, heights);
  case GDT_UInt64:
    return convert(static_cast<const std::uint64_t*>(raw), count, unsignedLow_, unsignedHigh_,
                   heights);
  default:
    return convert(static_cast<const float*>(raw), count, floatLow_, floatHigh_, heights);
  }
}

} // namespace qmesh
