// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/star_judge.h"

#include <algorithm>
#include <array>

namespace qmesh {

void StarJudge::reset(const HeightTile& tile, const TileFrame& frame, const Border& border,
                      const BaseGrid& grid, const CollapseMesh& mesh,
                      std::optional<double> maxError) {
  mesh_ = &mesh;
  grid_ = grid;
  tolerance_.reset();
  if (!maxError)
    return;
  heights_.reset(tile, frame);
  tolerance_ = heights_.scanTolerance(*maxError);
  // The vertices of a final edge are given; its other nodes have no say.
  const int n = frame.cells();
  for (int k = 0; k <= n; ++k) {
    if (!border.isFree[kWest])
      heights_.mask(0, k);
    if (!border.isFree[kSouth])
      heights_.mask(k, 0);
    if (!border.isFree[kEast])
      heights_.mask(n, k);
    if (!border.isFree[kNorth])
      heights_.mask(k, n);
  }
}

bool StarJudge::accepts(std::uint32_t first, std::uint32_t second, const CollapseVertex& placed,
                        const std::vector<TinTriangle>& star) const {
  using Corners = std::array<const SpanCorner*, 3>;
  const auto cornersOf = [&](const TinTriangle& t) {
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = t[k] == first || t[k] == second ? &placed.corner : &mesh_->vertices[t[k]].corner;
    return corners;
  };
  const auto vanishes = [&](const Corners& c) {
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
  };
  const auto isUpright = [&](const TinTriangle& t) {
    const Corners c = cornersOf(t);
    return vanishes(c) || doubledArea(*c[0], *c[1], *c[2]) > 0;
  };
  const auto isReachable = [&](const TinTriangle& t) {
    const Corners c = cornersOf(t);
    return std::all_of(c.begin(), c.end(),
                       [&](const SpanCorner* end) { return grid_.mayJoin(placed.corner, *end); });
  };
  const auto isWithin = [&](const TinTriangle& t) {
    const Corners c = cornersOf(t);
    return vanishes(c) || heights_.areWithin(*c[0], *c[1], *c[2], *tolerance_);
  };
  return std::all_of(star.begin(), star.end(), isUpright) &&
         std::all_of(star.begin(), star.end(), isReachable) &&
         (!tolerance_ || std::all_of(star.begin(), star.end(), isWithin));
}

} // namespace qmesh
