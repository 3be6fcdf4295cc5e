// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace qmesh {

/// A vertex as it is stored in the tile: all three 0..32767.
struct TinVertex {
  std::uint16_t u = 0;
  std::uint16_t v = 0;
  std::uint16_t q = 0; ///< quantized height, see TileFrame
};

/// CesiumJS reads a mesh of exactly so many vertices wrongly: one place takes its indices for 16
/// bits, another for 32.
inline constexpr std::size_t kForbiddenVertexCount = 65536;

using TinTriangle = std::array<std::uint32_t, 3>;

/// Why a simplifier stopped.
enum class StopReason {
  maxError,     ///< every node is within the level's max error
  allNodes,     ///< every node is a vertex
  parameter,    ///< the method's own parameter is reached: a count, a share, a threshold
  quantization, ///< rounding to the tile's frame alone exceeds the max error
};

/// A triangulation of exactly the tile's square: manifold, counter-clockwise in (u, v), no
/// degenerate triangle, no duplicate or unused vertex, never 65536 vertices (promise P6).
struct Tin {
  std::vector<TinVertex> vertices;
  std::vector<TinTriangle> triangles;
  double maxError = 0;        ///< metres, over all (N+1)^2 nodes, after quantization
  double sumSquaredError = 0; ///< square metres, over the same nodes
  StopReason reason = StopReason::maxError;

  void clear() {
    vertices.clear();
    triangles.clear();
    maxError = sumSquaredError = 0;
    reason = StopReason::maxError;
  }
};

} // namespace qmesh
