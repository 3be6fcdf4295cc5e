// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gdal_priv.h>

#include "base/status.h"
#include "source/pixel_level.h"
#include "source/raster_input.h"

namespace qmesh {

/// A rectangle of heights read from a raster; NaN where void.
struct PixelWindow {
  int column = 0; ///< of data[0]; may lie outside 0..columns-1 where the columns go round
  int row = 0;
  int width = 0;
  int height = 0;
  std::vector<float> data; ///< height rows of width

  bool contains(int c, int r) const {
    return c >= column && r >= row && c < column + width && r < row + height;
  }
  float at(int c, int r) const {
    return data[std::size_t(r - row) * std::size_t(width) + std::size_t(c - column)];
  }
};

/// Reads pixels of one level of a band as heights. Serves one thread.
class PixelReader {
 public:
  /// `band`, of a dataset of input.access, and `input` must outlive the reader; `period`: columns
  /// of the level that make a full turn, or 0.
  PixelReader(GDALRasterBand& band, const RasterInput& input, const PixelLevel& level, int period);

  /// Fills `window.data` for its rectangle. REQUIRES: rows inside the level; columns too unless
  /// they go round. Code::input where GDAL cannot read.
  Status read(PixelWindow& window);

  /// Bytes of scratch memory a reader takes at most.
  static std::size_t scratchBytes();

 private:
  Status readColumns(int column, int row, int width, int height, float* out, std::ptrdiff_t stride);
  Status readBlockMeans(int column, int row, int width, int height, float* out,
                        std::ptrdiff_t stride);
  Status readRaw(int column, int row, int width, int height, float* out, std::ptrdiff_t stride);
  Status readStrip(int column, int row, int width, int height, float* out, std::ptrdiff_t stride);
  void addRow(const float* raw, int width);
  void storeMeans(int blockRows, int rawColumn, int width, float* out);

  GDALRasterBand* band_;
  GDALRasterBand* mask_ = nullptr; ///< null: no mask beside nodata
  const RasterInput* input_;
  PixelLevel level_;
  int period_;
  std::vector<std::uint8_t> maskBytes_;
  std::vector<std::uint64_t> wide_; ///< pixels of 8 bytes before they become heights
  std::vector<float> raw_;          ///< pixels before they are averaged
  std::vector<double> sum_;
  std::vector<std::int64_t> count_;
};

} // namespace qmesh
