// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/grid_simplify_point_set.h>

#include "simplify/cgal/point_map.h"
#include "simplify/cgal/point_set_method.h"
#include "simplify/cgal/point_set_methods.h"

namespace qmesh {

namespace {

/// Of the nodes within each cube of a grid in space (CGAL grid_simplify_point_set) the first stays,
/// whichever it meets first in the tile's order.
class GridPoints final : public PointSetMethod {
 public:
  explicit GridPoints(const MethodOptions& options)
      : PointSetMethod(options), cellSize_(options.cellSize) {}

 protected:
  void choose(const PointSetSite& site, std::vector<NodePoint>& points) override {
    const double cellSize =
        cellSize_.valueOr(site.level.zoom, defaultCellSize(site, points.size()));
    points.erase(
        CGAL::grid_simplify_point_set(points, cellSize, CGAL::parameters::point_map(PositionMap())),
        points.end());
  }

 private:
  /// The cubes stand along the axes of the earth, so a surface with the normal n passes through
  /// (|n.x| + |n.y| + |n.z|) times as many as one that lies along them.
  static double defaultCellSize(const PointSetSite& site, std::size_t count) {
    const Vec3 up = site.up();
    const double slant = std::abs(up.x) + std::abs(up.y) + std::abs(up.z);
    return std::sqrt(site.area() * slant / (double(count) * site.share()));
  }

  LevelSpec cellSize_;
};

} // namespace

std::unique_ptr<Simplifier> createGridPoints(const MethodOptions& options) {
  return std::make_unique<GridPoints>(options);
}

} // namespace qmesh
