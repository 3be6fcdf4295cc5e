// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/inherit/edge_store.h"

#include <cassert>

namespace qmesh {

EdgeStore::Name EdgeStore::nameOf(TileId tile, Edge edge) const {
  switch (edge) {
  case kWest:
    return {tile.x, tile.y, false};
  case kSouth:
    return {tile.x, tile.y, true};
  case kEast:
    return {(tile.x + 1) % columns_, tile.y, false};
  case kNorth:
    break;
  }
  return {tile.x, tile.y + 1, true};
}

void EdgeStore::put(TileId tile, Edge edge, const std::vector<std::uint16_t>& places) {
  const std::lock_guard<std::mutex> lock(mutex_);
  edges_[nameOf(tile, edge)] = places;
}

std::vector<std::uint16_t> EdgeStore::take(TileId tile, Edge edge) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = edges_.find(nameOf(tile, edge));
  assert(found != edges_.end());
  std::vector<std::uint16_t> places = std::move(found->second);
  edges_.erase(found);
  return places;
}

} // namespace qmesh
