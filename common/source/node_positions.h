// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/status.h"
#include "source/crs.h"
#include "source/pixel_frame.h"
#include "tiling/node_lattice.h"

namespace qmesh {

/// A rectangle of nodes: columns already wrapped, so it never crosses the antimeridian.
struct NodeRectangle {
  std::int64_t i = 0;
  std::int64_t j = 0;
  int width = 0;
  int height = 0;
};

/// A box around the positions of a window; empty (west > east) when none has one.
struct PixelBounds {
  double west = 1e300, east = -1e300, north = 1e300, south = -1e300;

  bool complete = true; ///< every node has a position

  bool empty() const { return west > east; }
  void add(double x, double y);
};

/// Where nodes fall in pixel space: a pure function of the node's global position (i, j).
class NodePositions {
 public:
  virtual ~NodePositions() = default;

  /// Positions of the window's nodes, row by row, x[b * width + a]; x is NaN where a node has none.
  /// Returns a box that holds them all.
  virtual PixelBounds fill(const NodeRectangle& window, double* x, double* y) = 0;
};

/// For a geographic raster on WGS 84: arithmetic only.
std::unique_ptr<NodePositions> makeAffinePositions(const NodeLattice& lattice,
                                                   const PixelFrame& frame);

/// For every other system. Exact transforms at the corners of control cells, which are named by
/// global node positions (64 nodes wide, and 32, 16, 8 where a cell's bilinear interpolation misses
/// the exact transform at its centre or the middle of a side by more than 1/1024 pixel), and at
/// every node where 8 are too many. Nodes outside `extent` have no position: far from a
/// projection's own area its formulas may fold other places onto the raster.
Result<std::unique_ptr<NodePositions>> makeTransformedPositions(const NodeLattice& lattice,
                                                                const PixelFrame& frame,
                                                                const OGRSpatialReference& srs,
                                                                const GeoBox& extent,
                                                                const std::string& path);

} // namespace qmesh
