// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simplify/cgal/constrained_mesh.h"
#include "simplify/cgal/feature_lines.h"
#include "simplify/cgal/metric_nodes.h"
#include "simplify/simplifier.h"

namespace qmesh {

/// An inner node of a tile as a point of a set.
struct NodePoint {
  Vec3 position; ///< ECEF, metres
  NodeIndex node;
};

/// The tile a point set belongs to, and what the defaults of all methods stand on.
struct PointSetSite {
  const HeightTile& tile;
  const TileFrame& frame;
  const LevelParams& level;

  /// e / w: the max error over the tile's size, which counts as 40 km at most because mountains do
  /// not grow with the tile. 1/1040 with the default screen error from zoom 9 on.
  double relativeError() const;

  /// The share of the inner nodes that makes about as many triangles as greedy's default takes on
  /// ordinary terrain (docs/algorithms/features.md): of n nodes n / (1 + n e / w) stay, that is
  /// w / e of many.
  double share() const;

  /// The tile's area at its middle latitude, square metres.
  double area() const;

  /// The outward normal in the middle of the tile, ECEF.
  Vec3 up() const;
};

/// What the four point-set methods share, as in EMODnet's report "Quantized Mesh Generator" (2018):
/// sharp lines first, then a choice among the other nodes, then one constrained Delaunay
/// triangulation of all. The border is simplified alone unless it is free.
class PointSetMethod : public Simplifier {
 public:
  explicit PointSetMethod(const MethodOptions& options);

  void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                  Border& border) const override;
  bool choosesBorder() const override { return true; }
  Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                  const LevelParams& level, Tin& out) override;

 protected:
  /// Leaves of the points those that become vertices. They come in an order that depends on the
  /// tile's name alone and are at least one.
  virtual void choose(const PointSetSite& site, std::vector<NodePoint>& points) = 0;

 private:
  LevelParams edgeLevel(const LevelParams& level, int cells) const;
  void addFreeEdges(const PointSetSite& site, const Border& border);
  void addBaseGrid(const PointSetSite& site);
  void listPoints(const PointSetSite& site);

  LevelSpec borderMaxError_;
  LevelSpec borderMaxLength_;
  FeatureRules rules_;
  MetricNodes positions_;
  FeatureTracer tracer_;
  std::vector<std::uint8_t> taken_; ///< by node: not a point any more
  MeshParts parts_;
  std::vector<NodePoint> points_;
};

} // namespace qmesh
