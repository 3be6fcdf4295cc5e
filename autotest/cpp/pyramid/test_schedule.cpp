// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "pyramid/inherit/edge_store.h"
#include "pyramid/inherit/schedule.h"
#include "pyramid/inherit/tile_queue.h"

namespace qmesh {
namespace {

constexpr Schedule kSchedules[] = {Schedule::fourColour, Schedule::rowwise, Schedule::columnwise,
                                   Schedule::chessboard, Schedule::fourConnected};

/// The ranks as a drawing: rows from the north, as one looks at a map.
std::vector<std::vector<int>> drawing(const TileSchedule& schedule, const TileRange& box) {
  std::vector<std::vector<int>> rows(box.y1 - box.y0 + 1,
                                     std::vector<int>(box.x1 - box.x0 + 1, -1));
  for (std::uint32_t k = 0; k < schedule.count(); ++k) {
    const TileId id = schedule.tile(k);
    rows[box.y1 - id.y][id.x - box.x0] = int(schedule.rank(k));
  }
  return rows;
}

std::vector<std::vector<int>> drawn(Schedule schedule, int columns, int rows) {
  const TileRange box{4, 8, std::uint32_t(3 + columns), std::uint32_t(7 + rows)};
  return drawing(TileSchedule(Scheme(Profile::geodetic), 5, {box}, schedule), box);
}

using Drawing = std::vector<std::vector<int>>;

TEST(TileSchedule, GoesAsItIsDrawn) {
  EXPECT_EQ(drawn(Schedule::rowwise, 3, 3), (Drawing{{6, 7, 8}, {3, 4, 5}, {0, 1, 2}}));
  EXPECT_EQ(drawn(Schedule::columnwise, 3, 3), (Drawing{{2, 5, 8}, {1, 4, 7}, {0, 3, 6}}));
  EXPECT_EQ(drawn(Schedule::chessboard, 3, 3), (Drawing{{3, 8, 4}, {6, 2, 7}, {0, 5, 1}}));
  EXPECT_EQ(drawn(Schedule::fourColour, 3, 3), (Drawing{{2, 5, 3}, {6, 8, 7}, {0, 4, 1}}));
  // Both neighbours of the corner, then the tile between them, which has two built edges, ...
  EXPECT_EQ(drawn(Schedule::fourConnected, 3, 3), (Drawing{{6, 7, 8}, {2, 3, 5}, {0, 1, 4}}));
}

/// Random tiles of a level, row by row in one set.
std::vector<TileRange> randomTiles(const Scheme& scheme, int zoom, std::mt19937& random) {
  std::vector<TileRange> tiles;
  for (std::uint32_t y = 0; y < scheme.tilesY(zoom); ++y) {
    for (std::uint32_t x = 0; x < scheme.tilesX(zoom); ++x) {
      if (random() % 3 != 0)
        tiles.push_back({x, y, x, y});
    }
  }
  return tiles;
}

struct Case {
  Profile profile;
  int zoom;
};
constexpr Case kCases[] = {{Profile::geodetic, 0}, {Profile::geodetic, 1}, {Profile::geodetic, 3},
                           {Profile::mercator, 0}, {Profile::mercator, 1}, {Profile::mercator, 4}};

TEST(TileSchedule, IsATotalOrderWithSymmetricNeighbours) {
  std::mt19937 random(5);
  for (const Case& c : kCases) {
    for (const Schedule kind : kSchedules) {
      const Scheme scheme(c.profile);
      const TileSchedule schedule(scheme, c.zoom, randomTiles(scheme, c.zoom, random), kind);
      std::vector<bool> seen(schedule.count());
      for (std::uint32_t k = 0; k < schedule.count(); ++k) {
        ASSERT_LT(schedule.rank(k), schedule.count());
        EXPECT_FALSE(seen[schedule.rank(k)]);
        seen[schedule.rank(k)] = true;
        const auto around = schedule.neighbours(k);
        for (std::size_t edge = 0; edge < 4; ++edge) {
          if (!around[edge])
            continue;
          EXPECT_NE(*around[edge], k);
          EXPECT_EQ(schedule.neighbours(*around[edge])[(edge + 2) % 4], k);
        }
      }
    }
  }
}

TEST(TileSchedule, SeesNeighboursAcrossTheAntimeridian) {
  const Scheme scheme(Profile::geodetic);
  const TileSchedule schedule(scheme, 2, {{0, 1, 7, 1}}, Schedule::rowwise);
  EXPECT_EQ(schedule.neighbours(0)[kWest], 7u);
  EXPECT_EQ(schedule.neighbours(7)[kEast], 0u);
  EXPECT_EQ(schedule.earlierNeighbours(7), 2);
  EXPECT_EQ(schedule.neighbours(3)[kNorth], std::nullopt);
}

TEST(TileSchedule, TilesOfOneColourNeverTouch) {
  const TileSchedule schedule(Scheme(Profile::geodetic), 4, {{0, 0, 31, 15}}, Schedule::fourColour);
  const auto colour = [&](std::uint32_t k) { return schedule.rank(k) / (schedule.count() / 4); };
  for (std::uint32_t k = 0; k < schedule.count(); ++k) {
    for (const auto& neighbour : schedule.neighbours(k))
      EXPECT_TRUE(!neighbour || colour(*neighbour) != colour(k));
  }
}

/// The rule as it is written, looking at every tile at every step.
TEST(TileSchedule, FourConnectedTakesTheTileWithMostBuiltEdges) {
  std::mt19937 random(9);
  for (const Case& c : kCases) {
    const Scheme scheme(c.profile);
    const TileSchedule schedule(scheme, c.zoom, randomTiles(scheme, c.zoom, random),
                                Schedule::fourConnected);
    const std::uint32_t count = schedule.count();
    std::vector<int> edges(count, 0), since(count, 0);
    std::vector<bool> built(count);
    int clock = 0;
    for (std::uint32_t rank = 0; rank < count; ++rank) {
      std::uint32_t best = count;
      for (std::uint32_t k = 0; k < count; ++k) {
        const bool better = best == count || edges[k] > edges[best] ||
                            (edges[k] == edges[best] && since[k] < since[best]);
        if (!built[k] && better)
          best = k;
      }
      ASSERT_EQ(schedule.rank(best), rank);
      built[best] = true;
      for (const auto& neighbour : schedule.neighbours(best)) {
        if (neighbour && !built[*neighbour]) {
          ++edges[*neighbour];
          since[*neighbour] = ++clock;
        }
      }
    }
  }
}

/// Tiles finish in any order: none is handed out before its earlier neighbours are done, all are.
TEST(TileQueue, HandsOutATileWhenTheNeighboursBeforeItAreDone) {
  std::mt19937 random(3);
  const std::atomic<bool> stop{false};
  for (const Case& c : kCases) {
    for (const Schedule kind : kSchedules) {
      const Scheme scheme(c.profile);
      const TileSchedule schedule(scheme, c.zoom, randomTiles(scheme, c.zoom, random), kind);
      TileQueue queue(schedule);
      std::vector<bool> done(schedule.count());
      std::vector<std::uint32_t> inWork;
      std::uint32_t taken = 0;
      const auto finishOne = [&] {
        const std::size_t pick = random() % inWork.size();
        done[inWork[pick]] = true;
        queue.finish(inWork[pick]);
        inWork.erase(inWork.begin() + std::ptrdiff_t(pick));
      };
      const auto mayWait = [&] { // else next() would block this one thread
        for (std::uint32_t k = 0; k < schedule.count(); ++k) {
          const bool free = !done[k] && std::count(inWork.begin(), inWork.end(), k) == 0;
          bool ready = free;
          for (const auto& n : schedule.neighbours(k))
            ready = ready && (!n || schedule.rank(*n) > schedule.rank(k) || done[*n]);
          if (ready)
            return false;
        }
        return true;
      };
      while (taken < schedule.count()) {
        if (mayWait() || (inWork.size() > 2 && random() % 2)) {
          ASSERT_FALSE(inWork.empty());
          finishOne();
          continue;
        }
        const auto index = queue.next(stop);
        ASSERT_TRUE(index.has_value());
        ++taken;
        for (const auto& n : schedule.neighbours(*index))
          EXPECT_TRUE(!n || schedule.rank(*n) > schedule.rank(*index) || done[*n]);
        inWork.push_back(*index);
      }
      EXPECT_EQ(queue.next(stop), std::nullopt);
    }
  }
}

TEST(TileQueue, StopsWhenToldTo) {
  const TileSchedule schedule(Scheme(Profile::geodetic), 2, {{0, 0, 1, 0}}, Schedule::rowwise);
  TileQueue queue(schedule);
  std::atomic<bool> stop{false};
  EXPECT_EQ(queue.next(stop), 0u);
  stop = true; // tile 1 waits for tile 0, which never ends
  EXPECT_EQ(queue.next(stop), std::nullopt);
}

TEST(EdgeStore, TheTwoTilesOfAnEdgeNameItAlike) {
  EdgeStore edges(8);
  const std::vector<std::uint16_t> a{0, 5, 32767}, b{0, 7, 32767}, c{0, 9, 32767};
  edges.put({2, 7, 1}, kEast, a);
  edges.put({2, 7, 1}, kNorth, b);
  edges.put({2, 3, 2}, kSouth, c);
  EXPECT_EQ(edges.take({2, 0, 1}, kWest), a);
  EXPECT_EQ(edges.take({2, 7, 2}, kSouth), b);
  EXPECT_EQ(edges.take({2, 3, 1}, kNorth), c);
}

} // namespace
} // namespace qmesh
