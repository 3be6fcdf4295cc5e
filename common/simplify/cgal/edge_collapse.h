// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <cstddef>
#include <optional>

#include "mesh/tin.h"
#include "simplify/cgal/collapse_mesh.h"
#include "simplify/cgal/star_judge.h"
#include "simplify/method_options.h"

namespace qmesh {

/// How edges are chosen and how long.
struct CollapseRule {
  CollapseCost cost = CollapseCost::lindstromTurk;
  double volumeWeight = 0.5;
  double boundaryWeight = 0.5;
  double shapeWeight = 0;
  /// What a unit of u, a unit of v and a metre are worth in the space it works in.
  double perU = 1, perV = 1, perMetre = 1;
  /// Edges to leave; without a number edges collapse as long as the judge accepts any.
  std::optional<std::size_t> edges;
};

/// Collapses edges of a mesh, cheapest first (CGAL Surface_mesh_simplification), each as the judge
/// accepts: a fixed vertex keeps its place, an edge with one end on the border collapses to that
/// end. `mesh` is used up; what is left of it goes to `out`, without measures.
void collapseEdges(const CollapseRule& rule, const VertexRounding& rounding, const StarJudge& judge,
                   CollapseMesh& mesh, Tin& out);

} // namespace qmesh
