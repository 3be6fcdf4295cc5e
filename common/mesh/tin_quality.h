// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>

#include "grid/height_tile.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"

namespace qmesh {

/// A distribution of errors, metres.
struct ErrorSums {
  double max = 0;
  double sum = 0;
  double sumSquared = 0;

  void add(double error);
  void add(const ErrorSums& other);
};

/// How good a TIN is, of one tile or of several.
struct TinQuality {
  std::uint64_t nodes = 0;
  ErrorSums height;      ///< vertical
  ErrorSums distance;    ///< across the plane of the triangle above or below the node
  double minAngle = 180; ///< degrees, the sharpest angle of any triangle in space
  double sumAngles = 0;  ///< degrees, each triangle's sharpest angle
  std::uint64_t triangles = 0;

  void add(const TinQuality& other);
  double mean(const ErrorSums& errors) const { return nodes ? errors.sum / double(nodes) : 0; }
  double rms(const ErrorSums& errors) const;
  double meanAngle() const { return triangles ? sumAngles / double(triangles) : 0; }
};

/// Measures the decoded TIN at each of the (N+1)^2 nodes. Lengths are metres on the sphere of the
/// ellipsoid's larger radius, at the latitude of each triangle's middle.
/// REQUIRES: the TIN covers the square.
TinQuality measureQuality(const HeightTile& tile, const TileFrame& frame, const Tin& tin);

} // namespace qmesh
