// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "geo/vec3.h"
#include "mesh/base_grid.h"
#include "simplify/metric_scale.h"
#include "simplify/qem/collapse_log.h"
#include "simplify/qem/quadric.h"
#include "simplify/qem/vertex_heap.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// Simplifies a triangulation vertex by vertex, always where it costs least: half-edge collapse
/// with the quadric error of Garland & Heckbert (1997) and endpoint placement, so that vertices
/// stay nodes. A vertex may only move onto a neighbour that sees all others around it in (u, v), in
/// whole numbers: nothing ever folds over. Costs are brought up to date when a vertex comes to the
/// top of the heap (Cohen et al. 1997 call it lazy evaluation): they hardly ever fall.
class EdgeCollapser {
 public:
  /// Begins with a mesh. `stays[v]` != 0: vertex v never goes; those on the square's edges must. No
  /// edge becomes longer than the grid permits.
  /// REQUIRES: the mesh lives as long and nobody else changes it; a `log`, if not null, is cleared.
  void reset(Triangulation& mesh, const MetricScale& scale, const std::vector<std::uint8_t>& stays,
             const BaseGrid& grid, CollapseLog* log = nullptr);

  /// Vertices of the mesh as it is.
  std::size_t vertices() const { return vertices_; }

  /// The smallest visible object, metres (Ai et al. 2019): square root of the mean, over the
  /// vertices of the mesh as it is, of the least quadric error - of each vertex where it stands,
  /// as the mean square of its distances to the planes it stands for. 0 for the full mesh.
  double svo() const;

  /// False when no vertex can go any more. Else the cheapest collapse is known:
  bool findNext();
  /// - what it costs, square metres; the smallest visible object after it, metres;
  double nextError() const { return heap_.cost(heap_.top()); }
  double nextSvo() const;
  /// - and it can be done. REQUIRES for these three: findNext() just returned true.
  void collapse();

 private:
  /// A neighbour of a vertex, its place relative to the vertex.
  struct Neighbour {
    std::int32_t vertex;
    std::int32_t u;
    std::int32_t v;
    double cost;        ///< of moving the vertex onto it
    std::uint32_t rank; ///< when it would go itself

    std::int64_t squaredLength() const { return std::int64_t(u) * u + std::int64_t(v) * v; }
    /// Cheaper; of equal ones the nearer, then the one that stays longer: no vertex gathers all
    /// others around it.
    bool isBetter(const Neighbour& o) const {
      if (cost != o.cost)
        return cost < o.cost;
      const std::int64_t here = squaredLength(), there = o.squaredLength();
      return here != there ? here < there : rank > o.rank;
    }
  };

  void addQuadrics();
  void evaluate(std::int32_t v);
  void readRing(std::int32_t v);
  void touch(std::int32_t v, std::int32_t target);
  bool seesRing(std::size_t m) const;
  double costOf(std::int32_t v, std::int32_t target) const;
  double meanError(std::int32_t v) const;
  void addToSum(double value);
  const Vec3& point(std::int32_t v) const { return points_[std::size_t(v)]; }
  const Quadric& quadric(std::int32_t v) const { return quadrics_[std::size_t(v)]; }

  Triangulation* mesh_ = nullptr;
  CollapseLog* log_ = nullptr;
  std::vector<std::uint8_t> stays_;
  BaseGrid grid_;
  std::vector<Vec3> points_;
  std::vector<Quadric> quadrics_;
  std::vector<double> ownError_;     ///< by vertex: of its quadric where it stands
  std::vector<std::int32_t> target_; ///< by vertex in the heap: the cheapest; kNone: to be found
  VertexHeap heap_;
  std::size_t vertices_ = 0;
  double errorSum_ = 0, errorRest_ = 0; ///< of meanError, compensated
  std::vector<std::int32_t> star_;
  std::vector<Neighbour> ring_;
  std::vector<std::int32_t> order_; ///< of the ring, as a heap: the best in front
};

} // namespace qmesh
