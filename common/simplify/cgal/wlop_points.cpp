// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cmath>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include "geo/ellipsoid.h"
#include "simplify/cgal/point_map.h"
#include "simplify/cgal/point_set_method.h"
#include "simplify/cgal/point_set_methods.h"

namespace qmesh {

namespace {

/// Weighted locally optimal projection moves a share of the nodes until they are spread evenly over
/// the surface (CGAL wlop_simplify_and_regularize_point_set). What it returns lies between the
/// nodes and, on ridges and in valleys, beside the surface; so each point comes back as the node
/// nearest to it in longitude and latitude, with that node's height. Of points that come to one
/// node, or to one that is a vertex already, one is enough.
class WlopPoints final : public PointSetMethod {
 public:
  explicit WlopPoints(const MethodOptions& options)
      : PointSetMethod(options), percent_(options.retainPercent), radius_(options.radius),
        iterations_(options.iterations) {}

 protected:
  void choose(const PointSetSite& site, std::vector<NodePoint>& points) override {
    const double percent =
        std::clamp(percent_.valueOr(site.level.zoom, 100 * site.share()), 0.0, 100.0);
    const double radius = neighbourhood(site, double(points.size()) * percent / 100);
    moved_.clear();
    CGAL::wlop_simplify_and_regularize_point_set<CGAL::Sequential_tag>(
        points, std::back_inserter(moved_),
        CGAL::parameters::point_map(PositionMap())
            .select_percentage(percent)
            .neighbor_radius(radius)
            .number_of_iterations(unsigned(iterations_)));
    snap(site, points);
  }

 private:
  /// Metres: the option's, or what reaches the ring of points around each and half of the next: two
  /// whole rings take half as long again for 2 % of the error. Never so wide that all of a tile's
  /// nodes are all neighbours.
  double neighbourhood(const PointSetSite& site, double count) const {
    constexpr double kRings = 1.5, kLargestShare = 1.0 / 8;
    const double area = site.area();
    const double otherwise = kRings * std::sqrt(area / std::max(count, 1.0));
    return std::min(radius_.valueOr(site.level.zoom, otherwise), kLargestShare * std::sqrt(area));
  }

  /// Replaces the points by the nodes that the moved ones come to.
  void snap(const PointSetSite& site, std::vector<NodePoint>& points) {
    const NodeGrid grid(site.tile.cells());
    isPoint_.assign(grid.size(), 0);
    for (const NodePoint& point : points)
      isPoint_[std::size_t(point.node)] = 1;
    points.clear();
    const GeoBox box = site.tile.lattice().scheme().box(site.tile.id());
    for (const PointKernel::Point_3& p : moved_) {
      const wgs84::Geodetic place = wgs84::fromEcef({p.x(), p.y(), p.z()});
      const double east = std::remainder(place.longitudeDegrees - (box.west + box.east) / 2, 360);
      const double u = (east / (box.east - box.west) + 0.5) * kQuantizedMax;
      const double v =
          (place.latitudeDegrees - box.south) / (box.north - box.south) * kQuantizedMax;
      const auto rounded = [](double x) {
        return std::uint16_t(std::clamp(x, 0.0, double(kQuantizedMax)) + 0.5);
      };
      const NodeIndex node =
          grid.index(site.frame.nearestColumn(rounded(u)), site.frame.nearestRow(rounded(v)));
      if (isPoint_[std::size_t(node)])
        points.push_back({{p.x(), p.y(), p.z()}, node});
      isPoint_[std::size_t(node)] = 0;
    }
  }

  LevelSpec percent_;
  LevelSpec radius_;
  int iterations_;
  std::vector<PointKernel::Point_3> moved_;
  std::vector<std::uint8_t> isPoint_; ///< by node: free to become a vertex
};

} // namespace

std::unique_ptr<Simplifier> createWlopPoints(const MethodOptions& options) {
  return std::make_unique<WlopPoints>(options);
}

} // namespace qmesh
