// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/availability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace qmesh {

void PrintTo(const TileRange& r, std::ostream* out) {
  *out << "x " << r.x0 << ".." << r.x1 << " y " << r.y0 << ".." << r.y1;
}

namespace {

using Ranges = std::vector<TileRange>;
using Cells = std::set<std::pair<std::uint32_t, std::uint32_t>>; ///< (y, x)

/// The cells of disjoint rectangles; a cell met twice fails the test.
Cells cellsOf(const Ranges& ranges) {
  Cells cells;
  for (const TileRange& r : ranges)
    for (std::uint32_t y = r.y0; y <= r.y1; ++y)
      for (std::uint32_t x = r.x0; x <= r.x1; ++x)
        EXPECT_TRUE(cells.emplace(y, x).second) << "twice: " << x << ", " << y;
  return cells;
}

void expectSorted(const Ranges& ranges) {
  EXPECT_TRUE(std::is_sorted(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) {
    return std::pair(a.y0, a.x0) < std::pair(b.y0, b.x0);
  }));
}

/// Random numbers below a limit, of a fixed seed.
class Random {
 public:
  std::uint32_t below(std::uint32_t limit) { return std::uint32_t(engine_()) % limit; }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_{22};
};

TEST(Availability, EmptyHasNothing) {
  const Availability none;
  EXPECT_EQ(none.maxZoom(), -1);
  EXPECT_EQ(none.count(3), 0u);
  EXPECT_TRUE(none.ranges(0).empty());
  EXPECT_TRUE(none.rangesUnder({0, 0, 0}, 5).empty());
  EXPECT_FALSE(none.contains({0, 0, 0}));
}

//   y
//   2  . # # .        # from the three calls below
//   1  # # # .
//   0  # # . #
//      0 1 2 3  x
TEST(Availability, RectanglesOfASmallSet) {
  Availability set;
  set.add(3, {0, 0, 1, 1});
  set.add(3, {1, 1, 2, 2});
  set.add({3, 3, 0});
  EXPECT_EQ(set.ranges(3), (Ranges{{0, 0, 1, 0}, {3, 0, 3, 0}, {0, 1, 2, 1}, {1, 2, 2, 2}}));
  EXPECT_EQ(set.count(3), 8u);
  EXPECT_EQ(set.maxZoom(), 3);
  EXPECT_TRUE(set.contains({3, 2, 2}));
  EXPECT_FALSE(set.contains({3, 2, 0}));
  EXPECT_FALSE(set.contains({2, 0, 0}));
  EXPECT_TRUE(set.ranges(2).empty());
}

TEST(Availability, ABlockAddedTileByTileIsOneRectangle) {
  Availability set;
  std::vector<TileId> tiles;
  for (std::uint32_t y = 40; y < 60; ++y)
    for (std::uint32_t x = 7; x < 40; ++x)
      tiles.push_back({8, x, y});
  std::shuffle(tiles.begin(), tiles.end(), std::mt19937(21));
  for (const TileId& tile : tiles)
    set.add(tile);
  EXPECT_EQ(set.ranges(8), (Ranges{{7, 40, 39, 59}}));
}

TEST(Availability, TheWholeDeepestLevel) {
  Availability set;
  const Scheme scheme(Profile::geodetic);
  const std::uint32_t last = scheme.tilesX(kMaxZoom) - 1;
  set.add(kMaxZoom, {0, 5, last, 9});
  set.add({kMaxZoom, last, 5});
  EXPECT_EQ(set.ranges(kMaxZoom), (Ranges{{0, 5, last, 9}}));
  EXPECT_EQ(set.count(kMaxZoom), 5ull << 25);
  const std::uint32_t half = 1u << kMaxZoom;
  EXPECT_EQ(set.rangesUnder({0, 1, 0}, kMaxZoom), (Ranges{{half, 5, last, 9}}));
}

TEST(Availability, AgreesWithAPlainSet) {
  Random random;
  for (int round = 0; round < 300; ++round) {
    const int zoom = 5;
    Cells expected;
    Ranges calls;
    for (std::uint32_t k = random.below(40); k > 0; --k) {
      const std::uint32_t x = random.below(28), y = random.below(28);
      const TileRange range{x, y, x + random.below(4), y + random.below(4)};
      calls.push_back(range);
      for (std::uint32_t j = y; j <= range.y1; ++j)
        for (std::uint32_t i = x; i <= range.x1; ++i)
          expected.emplace(j, i);
    }
    Availability set, shuffled;
    for (const TileRange& range : calls)
      set.add(zoom, range);
    std::shuffle(calls.begin(), calls.end(), random.engine());
    for (const TileRange& range : calls)
      for (std::uint32_t y = range.y0; y <= range.y1; ++y)
        for (std::uint32_t x = range.x0; x <= range.x1; ++x)
          shuffled.add({zoom, x, y});

    const Ranges ranges = set.ranges(zoom);
    EXPECT_EQ(cellsOf(ranges), expected);
    expectSorted(ranges);
    EXPECT_EQ(shuffled.ranges(zoom), ranges);
    EXPECT_EQ(set.count(zoom), expected.size());
    for (std::uint32_t y = 0; y < 32; ++y)
      for (std::uint32_t x = 0; x < 32; ++x)
        EXPECT_EQ(set.contains({zoom, x, y}), expected.count({y, x}) == 1);

    const TileId ancestor{2, random.below(4), random.below(4)};
    Cells under;
    for (const auto& [y, x] : expected)
      if (x >> 3 == ancestor.x && y >> 3 == ancestor.y)
        under.emplace(y, x);
    EXPECT_EQ(cellsOf(set.rangesUnder(ancestor, zoom)), under);
    expectSorted(set.rangesUnder(ancestor, zoom));
  }
}

} // namespace
} // namespace qmesh
