// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/base_grid.h"
#include "simplify/metric_scale.h"
#include "simplify/node_heights.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// Takes vertices out of a triangulation again where its neighbourhood can do without: half-edge
/// collapses (Hoppe 1996) bounded in the maximum norm by the heights of all nodes around. Greedy
/// insertion leaves such vertices, because those that came first had to serve a coarser mesh.
class Decimator {
 public:
  /// One pass over the inner vertices in the order of their numbers. A vertex goes when every new
  /// triangle is counter-clockwise and no unmasked node of them, its own included, is off by more
  /// than the tolerance (metres). The grid's nodes stay, and no edge becomes longer than it
  /// permits. Returns how many went.
  int run(Triangulation& mesh, NodeHeights& heights, const BaseGrid& grid, float tolerance,
          const ErrorDistance& distance = {});

  /// Takes one vertex out, the first that the geometry permits; heights do not count.
  /// False when there is none.
  bool removeAny(Triangulation& mesh, NodeHeights& heights);

 private:
  /// A neighbour of the vertex, its place relative to the vertex.
  struct Neighbour {
    std::int32_t vertex;
    std::int32_t u;
    std::int32_t v;
    double height;
    std::int32_t area; ///< doubled, of the star's triangle to the next neighbour
  };

  /// A neighbour to move the vertex onto and the error this makes at the vertex.
  struct Target {
    float error;
    int ringIndex;
  };

  bool tryRemove(Triangulation& mesh, NodeHeights& heights, std::int32_t v, float tolerance);
  void readRing(const Triangulation& mesh, std::int32_t v);
  bool fan(std::size_t m, double height, float limit, float& error) const;
  bool isWithin(const Triangulation& mesh, const NodeHeights& heights, std::size_t m,
                float tolerance) const;
  bool mayJoin(const Neighbour& a, const Neighbour& b) const {
    const std::int64_t u = a.u - b.u, v = a.v - b.v;
    return grid_.isShort(u * u + v * v);
  }
  const Neighbour& around(std::size_t k) const {
    return ring_[k < ring_.size() ? k : k - ring_.size()];
  }

  ErrorDistance distance_;
  BaseGrid grid_;
  std::vector<std::int32_t> star_; ///< half-edges that leave the vertex
  std::vector<Neighbour> ring_;    ///< their ends, counter-clockwise
  std::vector<Target> targets_;
};

} // namespace qmesh
