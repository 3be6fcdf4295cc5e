// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/pixel_reader.h"

#include <algorithm>
#include <limits>

#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
/// Pixels of a strip that goes through scratch memory.
constexpr int kStripPixels = 1 << 17;
/// Pixels read at once before they are averaged; at least the largest block.
constexpr int kRawPixels = 1 << 19;

} // namespace

PixelReader::PixelReader(GDALRasterBand& band, const RasterInput& input, const PixelLevel& level,
                         int period)
    : band_(level.overview < 0 ? &band : band.GetOverview(level.overview)), input_(&input),
      level_(level), period_(period) {
  const int flags = band_->GetMaskFlags();
  const bool byNodata = (flags & GMF_NODATA) && !(flags & GMF_PER_DATASET);
  if (!(flags & GMF_ALL_VALID) && !byNodata)
    mask_ = band_->GetMaskBand();
}

std::size_t PixelReader::scratchBytes() {
  return std::size_t(kStripPixels) * 9 + std::size_t(kRawPixels) * (sizeof(float) + 16);
}

Status PixelReader::read(PixelWindow& window) {
  window.data.resize(std::size_t(window.width) * std::size_t(window.height));
  int done = 0;
  while (done < window.width) {
    int column = window.column + done;
    int count = window.width - done;
    if (period_ > 0) {
      column = ((column % period_) + period_) % period_;
      count = std::min(count, period_ - column);
    }
    QMESH_RETURN_IF_ERROR(readColumns(column, window.row, count, window.height,
                                      window.data.data() + done, window.width));
    done += count;
  }
  return {};
}

Status PixelReader::readColumns(int column, int row, int width, int height, float* out,
                                std::ptrdiff_t stride) {
  if (level_.blockX > 1 || level_.blockY > 1)
    return readBlockMeans(column, row, width, height, out, stride);
  return readRaw(column, row, width, height, out, stride);
}

Status PixelReader::readBlockMeans(int column, int row, int width, int height, float* out,
                                   std::ptrdiff_t stride) {
  raw_.resize(kRawPixels);
  const int blockX = level_.blockX;
  const int blockY = level_.blockY;
  const int group = std::max(1, std::min(width, kRawPixels / blockX / std::min(blockY, 64)));
  const int rowEnd =
      int(std::min<std::int64_t>(std::int64_t(row + height) * blockY, level_.sourceRows));
  for (int first = 0; first < width; first += group) {
    const int means = std::min(group, width - first);
    const int rawColumn = (column + first) * blockX;
    const int rawWidth = std::min(means * blockX, level_.sourceColumns - rawColumn);
    const int strip = std::max(1, kRawPixels / rawWidth);
    sum_.assign(std::size_t(means), 0);
    count_.assign(std::size_t(means), 0);
    for (int r = row * blockY; r < rowEnd; r += strip) {
      const int rows = std::min(strip, rowEnd - r);
      QMESH_RETURN_IF_ERROR(readRaw(rawColumn, r, rawWidth, rows, raw_.data(), rawWidth));
      for (int k = 0; k < rows; ++k) {
        addRow(raw_.data() + std::ptrdiff_t(k) * rawWidth, rawWidth);
        const int block = (r + k) / blockY;
        if (r + k + 1 == rowEnd || (r + k + 1) % blockY == 0)
          storeMeans(r + k + 1 - block * blockY, rawColumn, means,
                     out + (block - row) * stride + first);
      }
    }
  }
  return {};
}

void PixelReader::addRow(const float* raw, int width) {
  for (int k = 0; k < width; ++k)
    if (raw[k] == raw[k]) {
      const auto mean = std::size_t(k / level_.blockX);
      sum_[mean] += raw[k];
      ++count_[mean];
    }
}

void PixelReader::storeMeans(int blockRows, int rawColumn, int width, float* out) {
  for (int k = 0; k < width; ++k) {
    const int blockColumns =
        std::min(level_.blockX, level_.sourceColumns - (rawColumn + k * level_.blockX));
    const std::int64_t pixels = std::int64_t(blockColumns) * blockRows;
    const std::int64_t valid = count_[std::size_t(k)];
    out[k] = 2 * valid >= pixels ? float(sum_[std::size_t(k)] / double(valid)) : kVoid;
    sum_[std::size_t(k)] = 0;
    count_[std::size_t(k)] = 0;
  }
}

Status PixelReader::readRaw(int column, int row, int width, int height, float* out,
                            std::ptrdiff_t stride) {
  if (!mask_ && input_->values.readType() == GDT_Float32)
    return readStrip(column, row, width, height, out, stride);
  const int columnsAtOnce = std::min(width, kStripPixels);
  const int rowsAtOnce = std::max(1, kStripPixels / columnsAtOnce);
  for (int r = 0; r < height; r += rowsAtOnce)
    for (int c = 0; c < width; c += columnsAtOnce)
      QMESH_RETURN_IF_ERROR(readStrip(column + c, row + r, std::min(columnsAtOnce, width - c),
                                      std::min(rowsAtOnce, height - r), out + r * stride + c,
                                      stride));
  return {};
}

Status PixelReader::readStrip(int column, int row, int width, int height, float* out,
                              std::ptrdiff_t stride) {
  QuietErrors errors;
  const PixelValues& values = input_->values;
  const GDALDataType type = values.readType();
  const bool direct = type == GDT_Float32;
  if (!direct)
    wide_.resize(std::size_t(width) * std::size_t(height));
  void* target = direct ? static_cast<void*>(out) : wide_.data();
  const std::ptrdiff_t pitch = direct ? stride : width;
  std::unique_lock<std::mutex> lock = lockOf(input_->access.mutex());
  CPLErr failed = band_->RasterIO(GF_Read, column, row, width, height, target, width, height, type,
                                  0, GSpacing(pitch) * values.bytesPerPixel(), nullptr);
  if (failed == CE_None && mask_) {
    maskBytes_.resize(std::size_t(width) * std::size_t(height));
    failed = mask_->RasterIO(GF_Read, column, row, width, height, maskBytes_.data(), width, height,
                             GDT_Byte, 0, 0, nullptr);
  }
  if (lock)
    lock.unlock();
  if (failed != CE_None)
    return {Code::input, errors.explain("'" + input_->path + "' cannot be read at column " +
                                        std::to_string(column) + ", row " + std::to_string(row) +
                                        "; the file may be damaged")};
  for (int r = 0; r < height; ++r) {
    float* line = out + r * stride;
    const void* raw =
        direct ? static_cast<const void*>(line) : wide_.data() + std::ptrdiff_t(r) * width;
    values.toHeights(raw, std::size_t(width), line);
    const std::uint8_t* mask = mask_ ? maskBytes_.data() + std::ptrdiff_t(r) * width : nullptr;
    for (int c = 0; mask && c < width; ++c)
      if (mask[c] == 0)
        line[c] = kVoid;
  }
  return {};
}

} // namespace qmesh
