// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>

#include "geo/vec3.h"
#include "grid/height_tile.h"
#include "simplify/method_options.h"

namespace qmesh {

/// Somebody who looks at the terrain from a place: thresholds grow with the distance d from it as
/// max(1, d / range), so that what is seen under a small angle is coarse.
class Observer {
 public:
  /// No observer where the options name none: the factor is 1 everywhere.
  explicit Observer(const MethodOptions& options);

  bool exists() const { return place_.has_value(); }

  /// The factor for the nodes of columns i..i+across and rows j..j+up of a tile: from the straight
  /// distance to the nearest point (in longitude and latitude) of that box on the ellipsoid. A pure
  /// function of the nodes' names: both tiles of an edge find the same.
  double factor(const HeightTile& tile, int i, int j, int across, int up) const;

 private:
  std::optional<std::array<double, 3>> place_;
  Vec3 position_;
  double range_;
};

} // namespace qmesh
