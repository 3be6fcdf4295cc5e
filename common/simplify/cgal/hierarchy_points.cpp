// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>

#include <CGAL/Diagonalize_traits.h>
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
    const double size = clusterSize_.valueOr(zoom, kSizeOfShare / site.share());
    const double variance = maxVariance_.valueOr(zoom, kVarianceOfError * site.relativeError());
    const auto parameters =
        CGAL::parameters::point_map(PositionMap())
            .size(unsigned(std::clamp(size, 1.0, kLargestCluster)))
            .maximum_variation(std::clamp(variance, kLeastVariance, kLargestVariance))
            .diagonalize_traits(CGAL::Diagonalize_traits<double, 3>());
    points.erase(CGAL::hierarchy_simplify_point_set(points, parameters), points.end());
  }

 private:
  /// Clusters end at half their limit to all of it, 1 / 1.4 of it as a mean; with twice that limit
  /// half of the points come from it, and on ordinary terrain the others from the variation.
  static constexpr double kSizeOfShare = 2.8;
  /// By experiment: rough terrain gets more points than greedy gives it, smooth terrain fewer.
  static constexpr double kVarianceOfError = 8;

  LevelSpec clusterSize_;
  LevelSpec maxVariance_;
};

} // namespace

std::unique_ptr<Simplifier> createHierarchyPoints(const MethodOptions& options) {
  return std::make_unique<HierarchyPoints>(options);
}

} // namespace qmesh
