// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/listed_tiles.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

namespace qmesh {
namespace {

/// Rows that overlapping rectangles of a level may have together.
constexpr std::uint64_t kMostRows = 1u << 20;

bool isBefore(const TileRange& a, const TileRange& b) {
  return a.y0 != b.y0 ? a.y0 < b.y0 : a.x0 < b.x0;
}

/// Sweeps over the rows with the rectangles that reach them, west to east.
class OverlapSweep {
 public:
  /// REQUIRES: sorted by isBefore.
  static bool anyOverlap(const std::vector<TileRange>& ranges) {
    std::vector<std::size_t> byEnd(ranges.size());
    std::iota(byEnd.begin(), byEnd.end(), std::size_t(0));
    std::sort(byEnd.begin(), byEnd.end(),
              [&](std::size_t a, std::size_t b) { return ranges[a].y1 < ranges[b].y1; });
    OverlapSweep sweep;
    auto ended = byEnd.begin();
    for (const TileRange& range : ranges) {
      for (; ended != byEnd.end() && ranges[*ended].y1 < range.y0; ++ended)
        sweep.lastColumn_.erase(ranges[*ended].x0);
      if (!sweep.enter(range))
        return true;
    }
    return false;
  }

 private:
  bool enter(const TileRange& range) {
    const auto next = lastColumn_.lower_bound(range.x0);
    if (next != lastColumn_.end() && next->first <= range.x1)
      return false;
    if (next != lastColumn_.begin() && std::prev(next)->second >= range.x0)
      return false;
    lastColumn_.emplace_hint(next, range.x0, range.x1);
    return true;
  }

  std::map<std::uint32_t, std::uint32_t> lastColumn_; ///< by first column
};

/// The same tiles as rectangles that do not overlap, sorted.
Result<std::vector<TileRange>> disjoint(std::vector<TileRange> ranges, int zoom) {
  std::sort(ranges.begin(), ranges.end(), isBefore);
  if (!OverlapSweep::anyOverlap(ranges))
    return ranges;
  std::uint64_t rows = 0;
  for (const TileRange& range : ranges)
    rows += std::uint64_t(range.y1) - range.y0 + 1;
  if (rows > kMostRows)
    return Status(Code::input, "layer.json cannot be used: too many ranges under \"available\" "
                               "overlap at zoom " +
                                   std::to_string(zoom) + ".");
  Availability joined;
  for (const TileRange& range : ranges)
    joined.add(zoom, range);
  return joined.ranges(zoom);
}

} // namespace

Result<ListedTiles> ListedTiles::of(const std::vector<std::vector<TileRange>>& levels) {
  ListedTiles listed;
  for (std::size_t zoom = 0; zoom < levels.size(); ++zoom) {
    Result<std::vector<TileRange>> ranges = disjoint(levels[zoom], int(zoom));
    if (!ranges.ok())
      return ranges.status();
    Level level;
    level.ranges = std::move(*ranges);
    level.lastRow.resize(level.ranges.size());
    fillLastRows(level, 0, level.ranges.size());
    listed.levels_.push_back(std::move(level));
  }
  return listed;
}

std::uint32_t ListedTiles::fillLastRows(Level& level, std::size_t begin, std::size_t end) {
  if (begin == end)
    return 0;
  const std::size_t middle = begin + (end - begin) / 2;
  return level.lastRow[middle] =
             std::max({level.ranges[middle].y1, fillLastRows(level, begin, middle),
                       fillLastRows(level, middle + 1, end)});
}

bool ListedTiles::holds(const Level& level, std::size_t begin, std::size_t end, TileId tile) {
  while (begin != end) {
    const std::size_t middle = begin + (end - begin) / 2;
    if (level.lastRow[middle] < tile.y)
      return false;
    const TileRange& range = level.ranges[middle];
    if (range.contains(tile.x, tile.y) || holds(level, begin, middle, tile))
      return true;
    if (range.y0 > tile.y)
      return false;
    begin = middle + 1;
  }
  return false;
}

bool ListedTiles::contains(TileId tile) const {
  if (tile.z < 0 || std::size_t(tile.z) >= levels_.size())
    return false;
  const Level& level = levels_[std::size_t(tile.z)];
  return holds(level, 0, level.ranges.size(), tile);
}

int ListedTiles::maxZoom() const {
  int zoom = int(levels_.size()) - 1;
  while (zoom >= 0 && levels_[std::size_t(zoom)].ranges.empty())
    --zoom;
  return zoom;
}

const std::vector<TileRange>& ListedTiles::ranges(int zoom) const {
  static const std::vector<TileRange> kNone;
  return zoom < 0 || std::size_t(zoom) >= levels_.size() ? kNone
                                                         : levels_[std::size_t(zoom)].ranges;
}

std::uint64_t ListedTiles::count(int zoom) const {
  std::uint64_t sum = 0;
  for (const TileRange& range : ranges(zoom))
    sum += range.count();
  return sum;
}

std::optional<TileRange> ListedTiles::bounds(int zoom) const {
  std::optional<TileRange> box;
  for (const TileRange& range : ranges(zoom)) {
    if (!box)
      box = range;
    *box = {std::min(box->x0, range.x0), std::min(box->y0, range.y0), std::max(box->x1, range.x1),
            std::max(box->y1, range.y1)};
  }
  return box;
}

} // namespace qmesh
