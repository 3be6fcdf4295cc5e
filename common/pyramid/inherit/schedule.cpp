// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/inherit/schedule.h"

#include <algorithm>
#include <deque>
#include <numeric>
#include <utility>

namespace qmesh {

TileSchedule::TileSchedule(const Scheme& scheme, int zoom, const std::vector<TileRange>& tiles,
                           Schedule schedule)
    : scheme_(scheme), zoom_(zoom) {
  for (const TileRange& r : tiles) {
    for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
      for (std::uint32_t x = r.x0; x <= r.x1; ++x)
        tiles_.push_back({y, x});
    }
  }
  std::sort(tiles_.begin(), tiles_.end());
  ranks_.resize(tiles_.size());
  if (schedule == Schedule::fourConnected)
    rankByBuiltEdges();
  else
    rankBy(schedule);
}

std::optional<std::uint32_t> TileSchedule::find(std::uint32_t x, std::uint32_t y) const {
  const Place place{y, x};
  const auto at = std::lower_bound(tiles_.begin(), tiles_.end(), place);
  if (at == tiles_.end() || place < *at)
    return std::nullopt;
  return std::uint32_t(at - tiles_.begin());
}

std::array<std::optional<std::uint32_t>, 4> TileSchedule::neighbours(std::uint32_t index) const {
  const Place place = tiles_[index];
  const std::uint32_t columns = scheme_.tilesX(zoom_);
  std::array<std::optional<std::uint32_t>, 4> found;
  if (columns > 1) {
    found[0] = find((place.x + columns - 1) % columns, place.y);
    found[2] = find((place.x + 1) % columns, place.y);
  }
  if (place.y > 0)
    found[1] = find(place.x, place.y - 1);
  found[3] = find(place.x, place.y + 1);
  return found;
}

int TileSchedule::earlierNeighbours(std::uint32_t index) const {
  int count = 0;
  for (const auto& neighbour : neighbours(index))
    count += neighbour && ranks_[*neighbour] < ranks_[index] ? 1 : 0;
  return count;
}

void TileSchedule::rankBy(Schedule schedule) {
  const auto key = [&](std::uint32_t index) -> std::pair<std::uint32_t, std::uint32_t> {
    const Place& place = tiles_[index];
    switch (schedule) {
    case Schedule::fourColour:
      return {2 * (place.y % 2) + place.x % 2, index};
    case Schedule::chessboard:
      return {(place.x + place.y) % 2, index};
    case Schedule::columnwise:
      return {place.x, index};
    case Schedule::rowwise:
    case Schedule::fourConnected:
      break;
    }
    return {0, index};
  };
  std::vector<std::uint32_t> order(tiles_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::uint32_t k = 0; k < order.size(); ++k)
    ranks_[order[k]] = k;
}

/// Next is the tile with the most built edges, of equals the one that has had so many for the
/// longest; where none has any, the first one left, row by row.
void TileSchedule::rankByBuiltEdges() {
  std::vector<std::uint8_t> built(tiles_.size()); // edges; 255: the tile itself is
  constexpr std::uint8_t kDone = 255;
  std::array<std::deque<std::uint32_t>, 5> waiting; // by built edges; outdated entries are skipped
  std::uint32_t first = 0;
  const auto next = [&]() -> std::uint32_t {
    for (std::size_t edges = 4; edges >= 1; --edges) {
      while (!waiting[edges].empty()) {
        const std::uint32_t index = waiting[edges].front();
        waiting[edges].pop_front();
        if (built[index] == edges)
          return index;
      }
    }
    while (built[first] != 0)
      ++first;
    return first;
  };
  for (std::uint32_t rank = 0; rank < tiles_.size(); ++rank) {
    const std::uint32_t index = next();
    ranks_[index] = rank;
    built[index] = kDone;
    for (const auto& neighbour : neighbours(index)) {
      if (neighbour && built[*neighbour] != kDone)
        waiting[++built[*neighbour]].push_back(*neighbour);
    }
  }
}

} // namespace qmesh
