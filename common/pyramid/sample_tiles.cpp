// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/sample_tiles.h"

#include <algorithm>
#include <cmath>

#include "grid/void_fill.h"

namespace qmesh {

namespace {

/// The n-th tile of a level, in the order of its ranges.
TileId nthTile(const std::vector<TileRange>& ranges, int zoom, std::uint64_t n) {
  for (const TileRange& r : ranges) {
    if (n < r.count()) {
      const std::uint64_t columns = std::uint64_t(r.x1) - r.x0 + 1;
      return {zoom, r.x0 + std::uint32_t(n % columns), r.y0 + std::uint32_t(n / columns)};
    }
    n -= r.count();
  }
  return {zoom, ranges.front().x0, ranges.front().y0};
}

/// The k-th of numbers that spread over 0..count-1.
std::uint64_t spread(std::uint64_t k, std::uint64_t count) {
  const double place = (double(k) + 0.5) * 0.6180339887498949;
  return std::min(count - 1, std::uint64_t((place - std::floor(place)) * double(count)));
}

} // namespace

std::vector<TileId> spreadTiles(const Availability& tiles, int zoom, std::uint64_t most) {
  const std::uint64_t count = tiles.count(zoom);
  const auto ranges = tiles.ranges(zoom);
  std::vector<TileId> chosen;
  for (std::uint64_t k = 0; k < std::min(count, most); ++k)
    chosen.push_back(nthTile(ranges, zoom, count <= most ? k : spread(k, count)));
  return chosen;
}

Status sampleTile(const TilesetInput& input, NodeSource& nodes, TileId id, NodeWindow& window) {
  window.reset(input.plan.lattice(id.z), {id.x, id.y, id.x, id.y}, kTileHalo);
  const int first = window.firstExistingRow();
  QMESH_RETURN_IF_ERROR(nodes.sample(window.column0(), window.row0() + first, window.width(),
                                     window.endExistingRow() - first, window.row(first),
                                     window.stride()));
  window.setPoles(input.source.poleHeight(false), input.source.poleHeight(true));
  fillVoids(window, float(input.options.heights.voidValue));
  return {};
}

} // namespace qmesh
