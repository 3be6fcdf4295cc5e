// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <cstdint>
#include <vector>

#include "grid/height_tile.h"
#include "simplify/cgal/metric_nodes.h"
#include "simplify/cgal/node_index.h"

namespace qmesh {

/// What counts as a feature.
struct FeatureRules {
  double angleDegrees = 60; ///< a sharp edge: its triangles' normals differ by more
  int minimumEdges = 5;     ///< shorter lines are left out
};

/// Finds the lines along which the mesh of all nodes is sharp, in metric coordinates: ridges,
/// cliff tops and cliff feet. Memory is kept from tile to tile.
class FeatureTracer {
 public:
  /// The lines between ends and junctions, and closed ones; no two have an edge in common.
  /// `mayEnd` tells of border nodes which of them a line may reach; inner nodes always may.
  /// The order is that of the nodes they begin with.
  const std::vector<NodeLine>& trace(const HeightTile& tile, const MetricNodes& positions,
                                     const FeatureRules& rules,
                                     const std::vector<std::uint8_t>& mayEnd);

 private:
  void findSharpEdges(const MetricNodes& positions, double angleDegrees);
  void readRow(const MetricNodes& positions, int j, std::vector<Vec3>& row) const;
  void makeNormals(int j);
  void compareRow(int j, double cosine);
  void addEdge(int i, int j, int di, int dj);
  void dropForbidden(const std::vector<std::uint8_t>& mayEnd);
  void walk(NodeIndex from, int direction, int minimumEdges);
  NodeIndex follow(NodeIndex node, int direction);

  const HeightTile* tile_ = nullptr;
  NodeGrid grid_{0};
  std::vector<std::uint8_t> sharp_;    ///< by node: the directions of its sharp edges as bits
  std::vector<std::uint8_t> unwalked_; ///< those not yet in a line
  std::vector<Vec3> south_, north_;    ///< positions of two rows of nodes
  std::vector<Vec3> normals_, below_;  ///< two for each cell of a row, and of the row south of it
  std::vector<NodeLine> lines_;
};

} // namespace qmesh
