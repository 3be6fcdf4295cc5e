// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>
#include <vector>

#include "border/border.h"
#include "tiling/scheme.h"

namespace qmesh {

/// The edges of one level that are built and that a later tile still needs: put once by the tile
/// that comes first, taken once by the other. Many threads may call.
class EdgeStore {
 public:
  explicit EdgeStore(std::uint32_t columns) : columns_(columns) {}

  void put(TileId tile, Edge edge, const std::vector<std::uint16_t>& places);

  /// Moves the places out. REQUIRES: the tile beyond the edge has put them.
  std::vector<std::uint16_t> take(TileId tile, Edge edge);

 private:
  /// An edge by the tile east or north of it; eastwards: the south edge of that tile.
  struct Name {
    std::uint32_t x;
    std::uint32_t y;
    bool eastwards;
    bool operator<(const Name& o) const {
      return std::tie(y, x, eastwards) < std::tie(o.y, o.x, o.eastwards);
    }
  };
  Name nameOf(TileId tile, Edge edge) const;

  std::uint32_t columns_;
  std::mutex mutex_;
  std::map<Name, std::vector<std::uint16_t>> edges_;
};

} // namespace qmesh
