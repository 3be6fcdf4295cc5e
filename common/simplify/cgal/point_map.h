// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <boost/property_map/property_map.hpp>

#include "simplify/cgal/point_set_method.h"

namespace qmesh {

using PointKernel = CGAL::Simple_cartesian<double>;

/// How CGAL reads the position of a node. For this folder's sources only: it includes CGAL.
struct PositionMap {
  using key_type = NodePoint;
  using value_type = PointKernel::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  friend value_type get(const PositionMap&, const NodePoint& point) {
    return {point.position.x, point.position.y, point.position.z};
  }
};

} // namespace qmesh
