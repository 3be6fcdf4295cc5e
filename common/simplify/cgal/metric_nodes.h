// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <vector>

#include "geo/vec3.h"
#include "grid/height_tile.h"

namespace qmesh {

/// Where the nodes of a tile lie on the globe: ECEF, metres, on WGS 84 with heights above it.
class MetricNodes {
 public:
  /// REQUIRES: the tile lives as long as the positions are asked for.
  void reset(const HeightTile& tile);

  Vec3 at(int i, int j) const {
    const Foot& foot = rows_[std::size_t(j)];
    const Direction& east = columns_[std::size_t(i)];
    const double height = tile_->at(i, j);
    const double equatorial = foot.equatorial + height * foot.cosine;
    return {equatorial * east.cosine, equatorial * east.sine, foot.polar + height * foot.sine};
  }

 private:
  struct Direction {
    double cosine, sine; ///< of the longitude
  };
  struct Foot {
    double equatorial, polar; ///< distances of the ellipsoid from axis and equator, metres
    double cosine, sine;      ///< of the latitude
  };

  const HeightTile* tile_ = nullptr;
  std::vector<Direction> columns_;
  std::vector<Foot> rows_;
};

} // namespace qmesh
