// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/hierarchy_simplify_point_set.h>

#include "simplify/cgal/point_map.h"
#include "simplify/cgal/point_set_method.h"
#include "simplify/cgal/point_set_methods.h"

namespace qmesh {

namespace {

/// CGAL asks for a variation above 0.
constexpr double kLeastVariance = 1e-12;
constexpr double kLargestVariance = 1.0 / 3;
constexpr double kLargestCluster = 1 << 30;

/// Clusters are halved across their longest axis until they are small and flat enough; of each the
/// node nearest to its centre stays (CGAL hierarchy_simplify_point_set).
class HierarchyPoints final : public PointSetMethod {
 public:
  explicit HierarchyPoints(const MethodOptions& options)
      : PointSetMethod(options), clusterSize_(options.clusterSize),
        maxVariance_(options.maxVariance) {}

 protected:
  void choose(const PointSetSite& site, std::vector<NodePoint>& points) override {
    const int zoom = site.level.zoom;
    const double size =
        std::clamp(clusterSize_.at(zoom, kHalfFull / site.share()), 1.0, kLargestCluster);
    const double variance =
        std::clamp(maxVariance_.at(zoom, kLargestVariance), kLeastVariance, kLargestVariance);
    points.erase(
        CGAL::hierarchy_simplify_point_set(points, CGAL::parameters::point_map(PositionMap())
                                                       .size(unsigned(size))
                                                       .maximum_variation(variance)),
        points.end());
  }

 private:
  /// A cluster's size limit over the mean size of the clusters it leads to.
  static constexpr double kHalfFull = 1.4;

  LevelValue clusterSize_;
  LevelValue maxVariance_;
};

} // namespace

std::unique_ptr<Simplifier> createHierarchyPoints(const MethodOptions& options) {
  return std::make_unique<HierarchyPoints>(options);
}

} // namespace qmesh
