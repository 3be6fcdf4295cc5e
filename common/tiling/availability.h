// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tiling/scheme.h"

namespace qmesh {

/// A rectangle of tiles of one level, ends included, rows from the south.
struct TileRange {
  std::uint32_t x0 = 0;
  std::uint32_t y0 = 0;
  std::uint32_t x1 = 0;
  std::uint32_t y1 = 0;

  std::uint64_t count() const {
    return (std::uint64_t(x1) - x0 + 1) * (std::uint64_t(y1) - y0 + 1);
  }
  bool contains(std::uint32_t x, std::uint32_t y) const {
    return x >= x0 && x <= x1 && y >= y0 && y <= y1;
  }
  bool operator==(const TileRange& o) const {
    return x0 == o.x0 && y0 == o.y0 && x1 == o.x1 && y1 == o.y1;
  }
};

/// The tiles that exist, per level: what layer.json lists under `available`.
/// Not thread-safe: the owner guards it.
class Availability {
 public:
  /// Adds one tile (again is harmless).
  void add(TileId tile);
  void add(int zoom, const TileRange& range);
  void add(const Availability& other);

  bool contains(TileId tile) const;
  /// Deepest level with a tile, -1 when empty.
  int maxZoom() const;
  std::uint64_t count(int zoom) const;

  /// Disjoint rectangles that cover exactly the level's tiles, sorted by (y0, x0); rows with the
  /// same runs are joined. The same for any order of the calls to add.
  std::vector<TileRange> ranges(int zoom) const;
  /// The same, only of the descendants of `tile` at `zoom` (>= tile.z): for the metadata extension.
  std::vector<TileRange> rangesUnder(TileId tile, int zoom) const;

 private:
  /// A run of tiles [first, last] in a row.
  struct Run {
    std::uint32_t first;
    std::uint32_t last;
  };
  using Row = std::vector<Run>; ///< sorted, disjoint, not touching
  using NumberedRow = std::pair<std::uint32_t, Row>;
  struct Level {
    std::vector<NumberedRow> rows; ///< sorted by y
  };
  static bool isBelow(const NumberedRow& row, std::uint32_t y);
  static bool endsBefore(const Run& run, std::uint32_t x);
  Row& rowAt(int zoom, std::uint32_t y);
  const Row* findRow(int zoom, std::uint32_t y) const;
  /// The rectangles of a level, cut to a window.
  std::vector<TileRange> rangesWithin(int zoom, const TileRange& window) const;

  std::vector<Level> levels_;
};

} // namespace qmesh
