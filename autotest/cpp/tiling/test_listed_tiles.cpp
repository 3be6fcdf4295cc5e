// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tiling/listed_tiles.h"

#include <gtest/gtest.h>

#include <random>

namespace qmesh {
namespace {

/// Random rectangles, overlapping or not, against Availability, which keeps every row.
TEST(ListedTiles, HasTheTilesOfAvailability) {
  std::mt19937 random(3);
  for (int k = 0; k < 200; ++k) {
    const auto below = [&random](std::uint32_t limit) { return std::uint32_t(random()) % limit; };
    Availability rows;
    std::vector<std::vector<TileRange>> levels(6);
    const std::uint32_t count = below(12);
    for (std::uint32_t r = 0; r < count; ++r) {
      const TileRange range{below(60), below(30), 0, 0};
      levels[5].push_back(
          {range.x0, range.y0, range.x0 + below(64 - range.x0), range.y0 + below(3)});
      rows.add(5, {levels[5].back()});
    }
    const Result<ListedTiles> listed = ListedTiles::of(levels);
    ASSERT_TRUE(listed.ok());
    for (std::uint32_t y = 0; y < 32; ++y)
      for (std::uint32_t x = 0; x < 64; ++x)
        ASSERT_EQ(listed->contains({5, x, y}), rows.contains({5, x, y})) << k;
    EXPECT_EQ(listed->count(5), rows.count(5));
    EXPECT_EQ(listed->maxZoom(), rows.maxZoom());
    EXPECT_EQ(listed->bounds(5).has_value(), count > 0);
    EXPECT_FALSE(listed->contains({4, 0, 0}));
    EXPECT_FALSE(listed->contains({6, 0, 0}));
  }
}

TEST(ListedTiles, AWholeDeepLevelCostsNothing) {
  std::vector<std::vector<TileRange>> levels(kMaxZoom + 1);
  levels[kMaxZoom].push_back({0, 0, (2u << kMaxZoom) - 1, (1u << kMaxZoom) - 1});
  const Result<ListedTiles> listed = ListedTiles::of(levels);
  ASSERT_TRUE(listed.ok());
  EXPECT_EQ(listed->count(kMaxZoom), std::uint64_t(2) << (2 * kMaxZoom));
  EXPECT_TRUE(listed->contains({kMaxZoom, 5, 1u << 23}));
  EXPECT_EQ(listed->maxZoom(), kMaxZoom);

  levels[kMaxZoom].push_back({7, 7, 7, (1u << kMaxZoom) - 1});
  EXPECT_EQ(ListedTiles::of(levels).status().code(), Code::input);
}

} // namespace
} // namespace qmesh
