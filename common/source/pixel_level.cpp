// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/pixel_level.h"

#include <algorithm>
#include <cstdint>

namespace qmesh {
namespace {

/// Fewer pixels per node than this are left to the kernel.
constexpr double kStrongReduction = 8;
constexpr int kLargestBlock = 1 << 18;

/// The largest power of two that leaves at least half of kStrongReduction pixels per node and,
/// where the columns go round, divides their number.
int blockSize(double scale, int period) {
  int block = 1;
  while (scale / block >= kStrongReduction && block < kLargestBlock &&
         (period == 0 || period % (2 * block) == 0))
    block *= 2;
  return block;
}

/// Columns of a turn in an overview, 0 where that is not a whole number.
int overviewPeriod(const PixelFrame& frame, int overviewColumns) {
  const std::int64_t scaled = std::int64_t(frame.period) * overviewColumns;
  const auto columns = std::int64_t(frame.width);
  return scaled % columns == 0 ? int(scaled / columns) : 0;
}

} // namespace

PixelLevel PixelLevel::full(const PixelFrame& frame) {
  PixelLevel out;
  out.sourceColumns = int(frame.width);
  out.sourceRows = int(frame.height);
  return out;
}

PixelLevel PixelLevel::choose(GDALRasterBand& band, const PixelFrame& frame, double scaleX,
                              double scaleY) {
  PixelLevel out = full(frame);
  if (std::max(scaleX, scaleY) < kStrongReduction)
    return out;
  int period = frame.period;
  for (int k = 0; k < band.GetOverviewCount(); ++k) {
    GDALRasterBand* overview = band.GetOverview(k);
    if (!overview || overview->GetXSize() < 1 || overview->GetYSize() < 1 ||
        overview->GetXSize() >= out.sourceColumns)
      continue;
    const double ratioX = frame.width / overview->GetXSize();
    const double ratioY = frame.height / overview->GetYSize();
    const int turn = overviewPeriod(frame, overview->GetXSize());
    if (2 * ratioX > scaleX || 2 * ratioY > scaleY || (frame.period > 0 && turn == 0))
      continue;
    out.overview = k;
    out.sourceColumns = overview->GetXSize();
    out.sourceRows = overview->GetYSize();
    period = turn;
  }
  const double ratioX = frame.width / out.sourceColumns;
  const double ratioY = frame.height / out.sourceRows;
  out.blockX = blockSize(scaleX / ratioX, period);
  out.blockY = blockSize(scaleY / ratioY, 0);
  out.factorX = ratioX * out.blockX;
  out.factorY = ratioY * out.blockY;
  return out;
}

} // namespace qmesh
