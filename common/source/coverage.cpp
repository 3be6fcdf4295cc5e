// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/coverage.h"

#include <algorithm>
#include <deque>

namespace qmesh {
namespace {

constexpr int kSmallestSide = 64; ///< pixels; smaller holes are not worth a question
constexpr int kQuestions = 1000;  ///< each may ask all sources of a VRT

/// Halves what has both data and holes, the largest first, as long as questions are left.
std::vector<PixelRectangle> searchData(GDALRasterBand& band) {
  std::vector<PixelRectangle> found;
  std::deque<PixelRectangle> open{{0, 0, band.GetXSize(), band.GetYSize()}};
  int questions = kQuestions;
  for (; !open.empty(); open.pop_front()) {
    const PixelRectangle r = open.front();
    const int status =
        questions-- > 0 ? band.GetDataCoverageStatus(r.column, r.row, r.width, r.height, 0, nullptr)
                        : GDAL_DATA_COVERAGE_STATUS_DATA;
    if ((status & GDAL_DATA_COVERAGE_STATUS_DATA) == 0)
      continue;
    const bool mixed = (status & GDAL_DATA_COVERAGE_STATUS_EMPTY) != 0;
    if (!mixed || std::max(r.width, r.height) <= kSmallestSide) {
      found.push_back(r);
      continue;
    }
    PixelRectangle first = r, second = r;
    if (r.width >= r.height) {
      first.width = r.width / 2;
      second.column += first.width;
      second.width -= first.width;
    } else {
      first.height = r.height / 2;
      second.row += first.height;
      second.height -= first.height;
    }
    open.push_back(first);
    open.push_back(second);
  }
  return found;
}

/// Whether the pixels of a hole read as void: they get the band's nodata value, or 0.
bool holesAreVoid(GDALRasterBand& band) {
  int hasNodata = 0;
  band.GetNoDataValue(&hasNodata);
  return hasNodata != 0 || (band.GetMaskFlags() & GMF_PER_DATASET) != 0;
}

} // namespace

std::vector<PixelRectangle> dataCoverage(GDALRasterBand& band) {
  const PixelRectangle whole{0, 0, band.GetXSize(), band.GetYSize()};
  if (!holesAreVoid(band))
    return {whole};
  const int status = band.GetDataCoverageStatus(0, 0, whole.width, whole.height, 0, nullptr);
  const bool knowsHoles = (status & GDAL_DATA_COVERAGE_STATUS_UNIMPLEMENTED) == 0 &&
                          (status & GDAL_DATA_COVERAGE_STATUS_EMPTY) != 0;
  if (!knowsHoles)
    return {whole};
  std::vector<PixelRectangle> found = searchData(band);
  // A band that is one hole: sampling finds out, and says so.
  return found.empty() ? std::vector<PixelRectangle>{whole} : found;
}

} // namespace qmesh
