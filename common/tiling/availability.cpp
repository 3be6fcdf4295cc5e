// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/availability.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace qmesh {
namespace {

/// Joins the runs of rows, fed from south to north, into rectangles: a run continues the rectangle
/// of the row below that has exactly its columns, else it begins one. Rectangles are numbered as
/// they begin, hence sorted by (y0, x0).
class RangeJoiner {
 public:
  void beginRow(std::uint32_t y) {
    open_ = !ranges_.empty() && y == y_ + 1 ? std::move(row_) : std::vector<std::size_t>();
    row_.clear();
    next_ = 0;
    y_ = y;
  }

  /// The runs of a row from west to east.
  void addRun(std::uint32_t first, std::uint32_t last) {
    while (next_ < open_.size() && ranges_[open_[next_]].x0 < first)
      ++next_;
    if (next_ < open_.size()) {
      TileRange& below = ranges_[open_[next_]];
      if (below.x0 == first && below.x1 == last) {
        below.y1 = y_;
        row_.push_back(open_[next_]);
        return;
      }
    }
    row_.push_back(ranges_.size());
    ranges_.push_back({first, y_, last, y_});
  }

  std::vector<TileRange> take() { return std::move(ranges_); }

 private:
  std::vector<TileRange> ranges_;
  std::vector<std::size_t> open_; ///< rectangles that reach the row below, west to east
  std::vector<std::size_t> row_;  ///< rectangles that reach this row
  std::size_t next_ = 0;          ///< first of open_ that may meet the next run
  std::uint32_t y_ = 0;
};

} // namespace

void Availability::add(TileId tile) {
  add(tile.z, {tile.x, tile.y, tile.x, tile.y});
}

void Availability::add(int zoom, const TileRange& range) {
  assert(zoom >= 0 && zoom <= kMaxZoom && range.x0 <= range.x1 && range.y0 <= range.y1);
  for (std::uint64_t y = range.y0; y <= range.y1; ++y) {
    Row& row = rowAt(zoom, std::uint32_t(y));
    // The runs that overlap or touch the new one become part of it.
    const std::uint32_t reach = range.x0 == 0 ? 0 : range.x0 - 1;
    const auto begin = std::lower_bound(row.begin(), row.end(), reach, endsBefore);
    Run joined{range.x0, range.x1};
    auto end = begin;
    for (; end != row.end() && end->first <= std::uint64_t(range.x1) + 1; ++end)
      joined = {std::min(joined.first, end->first), std::max(joined.last, end->last)};
    row.insert(row.erase(begin, end), joined);
  }
}

void Availability::add(const Availability& other) {
  for (int zoom = 0; zoom <= other.maxZoom(); ++zoom)
    for (const TileRange& range : other.ranges(zoom))
      add(zoom, range);
}

bool Availability::contains(TileId tile) const {
  const Row* row = findRow(tile.z, tile.y);
  if (!row)
    return false;
  const auto run = std::lower_bound(row->begin(), row->end(), tile.x, endsBefore);
  return run != row->end() && run->first <= tile.x;
}

int Availability::maxZoom() const {
  return int(levels_.size()) - 1;
}

std::uint64_t Availability::count(int zoom) const {
  std::uint64_t tiles = 0;
  for (const TileRange& range : ranges(zoom))
    tiles += range.count();
  return tiles;
}

std::vector<TileRange> Availability::ranges(int zoom) const {
  constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();
  return rangesWithin(zoom, {0, 0, kEnd, kEnd});
}

std::vector<TileRange> Availability::rangesUnder(TileId tile, int zoom) const {
  assert(zoom >= tile.z && zoom <= kMaxZoom);
  const int depth = zoom - tile.z;
  const std::uint32_t last = (1u << depth) - 1;
  const std::uint32_t x = tile.x << depth;
  const std::uint32_t y = tile.y << depth;
  return rangesWithin(zoom, {x, y, x + last, y + last});
}

std::vector<TileRange> Availability::rangesWithin(int zoom, const TileRange& window) const {
  RangeJoiner joiner;
  if (zoom < 0 || zoom > maxZoom())
    return joiner.take();
  const auto& rows = levels_[std::size_t(zoom)].rows;
  for (auto row = std::lower_bound(rows.begin(), rows.end(), window.y0, isBelow);
       row != rows.end() && row->first <= window.y1; ++row) {
    joiner.beginRow(row->first);
    for (auto run = std::lower_bound(row->second.begin(), row->second.end(), window.x0, endsBefore);
         run != row->second.end() && run->first <= window.x1; ++run)
      joiner.addRun(std::max(run->first, window.x0), std::min(run->last, window.x1));
  }
  return joiner.take();
}

Availability::Row& Availability::rowAt(int zoom, std::uint32_t y) {
  if (zoom > maxZoom())
    levels_.resize(std::size_t(zoom) + 1);
  auto& rows = levels_[std::size_t(zoom)].rows;
  const auto row = std::lower_bound(rows.begin(), rows.end(), y, isBelow);
  if (row != rows.end() && row->first == y)
    return row->second;
  return rows.insert(row, {y, {}})->second;
}

const Availability::Row* Availability::findRow(int zoom, std::uint32_t y) const {
  if (zoom < 0 || zoom > maxZoom())
    return nullptr;
  const auto& rows = levels_[std::size_t(zoom)].rows;
  const auto row = std::lower_bound(rows.begin(), rows.end(), y, isBelow);
  return row != rows.end() && row->first == y ? &row->second : nullptr;
}

bool Availability::isBelow(const NumberedRow& row, std::uint32_t y) {
  return row.first < y;
}

bool Availability::endsBefore(const Run& run, std::uint32_t x) {
  return run.last < x;
}

} // namespace qmesh
