// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/enum_table.h"
#include "tiling/availability.h"

namespace qmesh {

/// Who decides the vertices of the edge between two tiles.
enum class BorderMode { shared, inherit };

template <> struct EnumTable<BorderMode> {
  static constexpr EnumRow<BorderMode> kRows[] = {
      {BorderMode::shared, "shared", "from the nodes of the edge alone; tiles in any order"},
      {BorderMode::inherit, "inherit", "by the tile that is made first; its neighbours use them"},
  };
};

/// The order of a level's tiles under BorderMode::inherit.
enum class Schedule { fourColour, rowwise, columnwise, chessboard, fourConnected };

template <> struct EnumTable<Schedule> {
  static constexpr EnumRow<Schedule> kRows[] = {
      {Schedule::fourColour, "four-colour", "by four colours; tiles of one colour do not touch"},
      {Schedule::rowwise, "rowwise", "row by row from the south"},
      {Schedule::columnwise, "columnwise", "column by column from the west"},
      {Schedule::chessboard, "chessboard", "black squares, then white squares"},
      {Schedule::fourConnected, "4connected", "tiles with the most finished edges first"},
      {Schedule::fourColour, "four-color"},
  };
};

/// The order of a level's tiles under --border inherit (docs/algorithms/borders.md), a function of
/// the tiles alone. A tile inherits the edges it shares with neighbours that come before it; those
/// are all it depends on, because the ends of an edge belong to every mesh.
/// Tiles are numbered row by row from the south. Takes 12 bytes a tile.
class TileSchedule {
 public:
  /// `tiles`: disjoint rectangles of the level.
  TileSchedule(const Scheme& scheme, int zoom, const std::vector<TileRange>& tiles,
               Schedule schedule);

  std::uint32_t count() const { return std::uint32_t(tiles_.size()); }
  TileId tile(std::uint32_t index) const { return {zoom_, tiles_[index].x, tiles_[index].y}; }

  /// Position in the order, 0..count() - 1.
  std::uint32_t rank(std::uint32_t index) const { return ranks_[index]; }

  /// The tile beyond each edge (border/border.h's order); none where the level ends or has no tile,
  /// and where the tile is its own neighbour.
  std::array<std::optional<std::uint32_t>, 4> neighbours(std::uint32_t index) const;

  /// How many neighbours come before the tile.
  int earlierNeighbours(std::uint32_t index) const;

 private:
  struct Place {
    std::uint32_t y;
    std::uint32_t x;
    bool operator<(const Place& o) const { return y != o.y ? y < o.y : x < o.x; }
  };

  std::optional<std::uint32_t> find(std::uint32_t x, std::uint32_t y) const;
  void rankBy(Schedule schedule);
  void rankByBuiltEdges();

  Scheme scheme_;
  int zoom_;
  std::vector<Place> tiles_; ///< sorted
  std::vector<std::uint32_t> ranks_;
};

} // namespace qmesh
