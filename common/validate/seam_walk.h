// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "tiling/scheme.h"
#include "validate/seam_checks.h"

namespace qmesh {

/// Compares the tiles of one level with their neighbours as they come, row by row from the south
/// and from the west in each row. Keeps the north edges of one row, not the tiles.
class SeamWalk {
 public:
  SeamWalk(Scheme scheme, int zoom, SeamReport& report)
      : scheme_(scheme), zoom_(zoom), report_(&report) {}

  /// A tile's edges; the next tile in the order.
  void add(TileId tile, std::array<TileEdge, 4> edges, Findings& findings);
  /// After the last tile.
  void finish(Findings& findings);

 private:
  struct Waiting {
    TileId tile;
    TileEdge edge;
  };
  void endRow(Findings& findings);
  void compare(TileId a, TileId b, const TileEdge& first, const TileEdge& second,
               Findings& findings);

  Scheme scheme_;
  int zoom_;
  SeamReport* report_;
  std::optional<std::uint32_t> row_;
  std::map<std::uint32_t, TileEdge> below_; ///< north edges of the row before, by column
  std::map<std::uint32_t, TileEdge> here_;
  std::optional<Waiting> west_;  ///< the east edge of the tile before
  std::optional<Waiting> first_; ///< the west edge of column 0, for the antimeridian
  std::vector<TileEdge> pole_;
};

} // namespace qmesh
