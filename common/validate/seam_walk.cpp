// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/seam_walk.h"

#include "validate/open_tileset.h"

namespace qmesh {

void SeamWalk::compare(TileId a, TileId b, const TileEdge& first, const TileEdge& second,
                       Findings& findings) {
  checkSeam(first, second, tileName(a) + " and " + tileName(b), *report_, findings);
}

void SeamWalk::add(TileId tile, std::array<TileEdge, 4> edges, // NOLINT: moved from
                   Findings& findings) {
  if (row_ != tile.y) {
    endRow(findings);
    if (!row_ || *row_ + 1 != tile.y)
      below_.clear();
    row_ = tile.y;
  }
  auto& [west, south, east, north] = edges;
  if (west_ && west_->tile.x + 1 == tile.x)
    compare(west_->tile, tile, west_->edge, west, findings);
  const auto under = below_.find(tile.x);
  if (under != below_.end())
    compare({tile.z, tile.x, tile.y - 1}, tile, under->second, south, findings);
  if (tile.x == 0)
    first_ = Waiting{tile, std::move(west)};
  const bool geodetic = scheme_.profile() == Profile::geodetic;
  if (geodetic && tile.y == 0)
    pole_.push_back(std::move(south));
  here_[tile.x] = std::move(north);
  west_ = Waiting{tile, std::move(east)};
}

void SeamWalk::endRow(Findings& findings) {
  if (!row_)
    return;
  if (west_ && first_ && west_->tile.x + 1 == scheme_.tilesX(zoom_))
    compare(west_->tile, first_->tile, west_->edge, first_->edge, findings);
  below_ = std::move(here_);
  here_.clear();
  west_.reset();
  first_.reset();
  if (*row_ == 0 && !pole_.empty()) {
    std::vector<const TileEdge*> row;
    for (const TileEdge& edge : pole_)
      row.push_back(&edge);
    checkPole(row, "south pole, zoom " + std::to_string(zoom_), findings);
    pole_.clear();
  }
  if (scheme_.profile() == Profile::geodetic && *row_ + 1 == scheme_.tilesY(zoom_)) {
    std::vector<const TileEdge*> row;
    for (const auto& [column, edge] : below_)
      row.push_back(&edge);
    checkPole(row, "north pole, zoom " + std::to_string(zoom_), findings);
  }
}

void SeamWalk::finish(Findings& findings) {
  endRow(findings);
}

} // namespace qmesh
