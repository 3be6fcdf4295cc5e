// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/status.h"
#include "tiling/availability.h"

namespace qmesh {

/// The tiles that a layer.json lists, as rectangles: memory by the number of rectangles, however
/// many rows they span, so that a few bytes of a foreign file cannot fill the machine (Availability
/// keeps rows). Const after construction: threads share it.
class ListedTiles {
 public:
  /// `levels`: rectangles per zoom from 0, inside their level's matrix; they may overlap.
  /// Code::input where so many of them overlap that they cannot be told apart in bounded memory.
  static Result<ListedTiles> of(const std::vector<std::vector<TileRange>>& levels);

  bool contains(TileId tile) const;
  /// Deepest level with a tile, -1 when empty.
  int maxZoom() const;
  /// Disjoint rectangles sorted by (y0, x0); none beyond the last level.
  const std::vector<TileRange>& ranges(int zoom) const;
  std::uint64_t count(int zoom) const;
  /// The smallest rectangle around the level's tiles; nothing where it has none.
  std::optional<TileRange> bounds(int zoom) const;

 private:
  /// Rectangles as a balanced tree over their places in the list: the root of [begin, end) is the
  /// one in the middle, `lastRow` the greatest y1 of the whole part.
  struct Level {
    std::vector<TileRange> ranges;
    std::vector<std::uint32_t> lastRow;
  };
  static std::uint32_t fillLastRows(Level& level, std::size_t begin, std::size_t end);
  static bool holds(const Level& level, std::size_t begin, std::size_t end, TileId tile);

  std::vector<Level> levels_;
};

} // namespace qmesh
