// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "grid/height_tile.h"
#include "mesh/error_measure.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"
#include "simplify/metric_scale.h"
#include "simplify/node_mesh.h"
#include "simplify/refinement_rounds.h"

namespace qmesh {

/// The last step of a method that keeps promise P2: what was decoded is measured in double
/// precision, and where an inner node is still beyond the max error it becomes a vertex, at as many
/// of its four places as it takes.
class ExactRefinement {
 public:
  /// REQUIRES: tile and frame live as long as this is used.
  void reset(const HeightTile& tile, const TileFrame& frame, double maxError);

  /// Errors are measured so until the next reset(). DEFAULT: heights.
  void setDistance(const ErrorDistance& distance) { distance_ = distance; }
  /// The nodes of these edges may become vertices until the next reset(). DEFAULT: of none.
  void setFreeEdges(const std::array<bool, 4>& isFree) { isFree_ = isFree; }

  /// Writes the mesh to `out` and inserts nodes until measureError() finds none beyond the max
  /// error, or none that can be helped: then rounding is to blame. Returns the last measure.
  ErrorMeasure run(NodeMesh& nodes, Tin& out);

  /// Inserts the worst node that still has a free place, whatever its error; false: there is none.
  bool insertWorst(NodeMesh& nodes);

 private:
  NodeError worstOf(const Triangulation& mesh, std::int32_t t, double tolerance) const;
  bool insertAtFreePlace(NodeMesh& nodes, const Candidate& candidate);
  void countPlaces(const Triangulation& mesh);
  bool mayBecomeVertex(int i, int j) const;
  int index(int i, int j) const { return j * (frame_->cells() + 1) + i; }

  const HeightTile* tile_ = nullptr;
  const TileFrame* frame_ = nullptr;
  double maxError_ = 0;
  ErrorDistance distance_;
  std::array<bool, 4> isFree_{};
  bool severalPlaces_ = false; ///< a node may have more than one of its places
  RefinementRounds rounds_;
  std::vector<double> nodeV_;
  std::unique_ptr<SpanList<double>> spans_ = std::make_unique<SpanList<double>>();
  std::vector<std::uint8_t> places_; ///< by node: which of its four places have a vertex, as bits
};

} // namespace qmesh
