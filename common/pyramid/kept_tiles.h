// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "tiling/availability.h"

namespace qmesh {

/// The tiles of the tileset as far as a block may know them: all of the levels that earlier stages
/// have made, and of its own levels those below its own tile. That is all a tile can ask for,
/// because its descendants belong to the same block or to an earlier stage.
class KeptTiles {
 public:
  /// Where all tiles are known. REQUIRES: the availability outlives this.
  KeptTiles(const Availability& all, int maxZoom)
      : finer_(&all), own_(&all), finestOwn_(maxZoom), maxZoom_(maxZoom) {}

  /// `own`: levels up to `finestOwn`; `finer`: the levels beyond. `maxZoom`: the deepest level.
  KeptTiles(const Availability& finer, const Availability& own, int finestOwn, int maxZoom)
      : finer_(&finer), own_(&own), finestOwn_(finestOwn), maxZoom_(maxZoom) {}

  bool contains(TileId tile) const { return of(tile.z).contains(tile); }
  bool containsChildOf(TileId tile) const;
  /// As Availability::rangesUnder().
  std::vector<TileRange> rangesUnder(TileId tile, int zoom) const {
    return of(zoom).rangesUnder(tile, zoom);
  }
  int maxZoom() const { return maxZoom_; }

 private:
  const Availability& of(int zoom) const { return zoom > finestOwn_ ? *finer_ : *own_; }

  const Availability* finer_;
  const Availability* own_;
  int finestOwn_;
  int maxZoom_;
};

inline bool KeptTiles::containsChildOf(TileId tile) const {
  for (std::uint32_t k = 0; k < 4; ++k)
    if (contains({tile.z + 1, 2 * tile.x + (k & 1), 2 * tile.y + (k >> 1)}))
      return true;
  return false;
}

} // namespace qmesh
