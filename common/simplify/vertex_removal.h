// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/base_grid.h"
#include "simplify/node_heights.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// Takes vertices out of a triangulation and fills the hole with triangles among its corners
/// (vertex decimation: Schroeder, Zarge & Lorensen 1992), bounded in the maximum norm. It finds
/// those that no edge collapse can take: where no single neighbour sees all others.
class VertexRemoval {
 public:
  /// One pass over the inner vertices in the order of their numbers; one goes when the hole can be
  /// filled by cutting ears so that no unmasked node is off by more than the tolerance (metres).
  /// The grid's nodes stay, and no edge becomes longer than it permits. Returns how many went.
  int run(Triangulation& mesh, const NodeHeights& heights, const BaseGrid& grid, float tolerance);

 private:
  bool tryRemove(Triangulation& mesh, const NodeHeights& heights, std::int32_t v, float tolerance);
  int bestEar(const Triangulation& mesh, const NodeHeights& heights, float tolerance) const;
  bool isEar(const Triangulation& mesh, std::size_t k) const;
  const SpanCorner& corner(const Triangulation& mesh, std::size_t k) const {
    return mesh.vertex(ring_[std::size_t(left_[k % left_.size()])]).corner;
  }

  BaseGrid grid_;
  std::vector<std::int32_t> star_;
  std::vector<std::int32_t> ring_;                ///< vertices around, counter-clockwise
  std::vector<std::int32_t> left_;                ///< corners of the hole's rest, as ring indices
  std::vector<std::array<std::int32_t, 3>> fill_; ///< triangles of ring indices
};

} // namespace qmesh
