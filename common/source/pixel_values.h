// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <gdal_priv.h>

namespace qmesh {

/// How the numbers of a band become heights in metres: void test on the raw number, then
/// raw * scale + offset, unit, sign. NaN, infinities and heights beyond 1e19 m are voids always.
class PixelValues {
 public:
  /// Reads the band's own record; `nodata` (-a) replaces the band's. Warnings name an unknown unit
  /// and a palette.
  static PixelValues of(GDALRasterBand& band, std::optional<double> nodata, bool depthsDown,
                        std::vector<std::string>& warnings);

  /// The type pixels are to be read in: one that keeps the band's numbers exact.
  GDALDataType readType() const { return readType_; }
  int bytesPerPixel() const { return readType_ == GDT_Float32 ? 4 : 8; }

  /// `count` numbers of readType() become heights, NaN where void; the two may be one array when
  /// readType() is GDT_Float32.
  void toHeights(const void* raw, std::size_t count, float* heights) const;

 private:
  template <class T>
  void convert(const T* raw, std::size_t count, T low, T high, float* heights) const;
  void setNodata(GDALRasterBand& band, std::optional<double> given);

  GDALDataType readType_ = GDT_Float32;
  double factor_ = 1; ///< scale, unit and sign in one
  double shift_ = 0;
  // Numbers low..high are void, in the type they are read in; low > high: none.
  float floatLow_ = 1, floatHigh_ = 0;
  double doubleLow_ = 1, doubleHigh_ = 0;
  std::int64_t signedLow_ = 1, signedHigh_ = 0;
  std::uint64_t unsignedLow_ = 1, unsignedHigh_ = 0;
};

/// Metres of one unit of a band's unit text ("m", "ft", "US survey foot", ...); nothing when
/// unknown.
std::optional<double> metresPerUnit(const std::string& unit);

} // namespace qmesh
