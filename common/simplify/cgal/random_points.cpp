// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>

#include "simplify/cgal/point_set_method.h"
#include "simplify/cgal/point_set_methods.h"

namespace qmesh {

namespace {

/// Keeps the first nodes in the tile's own random order. CGAL's random_simplify_point_set() does
/// the same after one more shuffle, whose generator the caller cannot choose and which may differ
/// between its versions; the tile's order is random enough.
class RandomPoints final : public PointSetMethod {
 public:
  explicit RandomPoints(const MethodOptions& options)
      : PointSetMethod(options), percent_(options.randomPercent) {}

 protected:
  void choose(const PointSetSite& site, std::vector<NodePoint>& points) override {
    const double removed = percent_.valueOr(site.level.zoom, 100 * (1 - site.share()));
    const double kept = double(points.size()) * (100 - std::clamp(removed, 0.0, 100.0)) / 100;
    points.resize(std::size_t(kept));
  }

 private:
  LevelSpec percent_;
};

} // namespace

std::unique_ptr<Simplifier> createRandomPoints(const MethodOptions& options) {
  return std::make_unique<RandomPoints>(options);
}

} // namespace qmesh
