// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/enum_table.h"
#include "tiling/level_spec.h"

namespace qmesh {

/// How greedy measures the distance of a node from the mesh.
enum class ErrorType { height, distance3d };

template <> struct EnumTable<ErrorType> {
  static constexpr EnumRow<ErrorType> kRows[] = {
      {ErrorType::height, "height", "vertical"},
      {ErrorType::distance3d, "3d", "across the triangle's plane, smaller on slopes"},
  };
};

/// What the collapse of an edge costs.
enum class CollapseCost { lindstromTurk, garlandHeckbert };

template <> struct EnumTable<CollapseCost> {
  static constexpr EnumRow<CollapseCost> kRows[] = {
      {CollapseCost::lindstromTurk, "lindstrom-turk", "keeps volume, boundary and shape"},
      {CollapseCost::garlandHeckbert, "garland-heckbert", "quadrics of the planes around"},
  };
};

/// The coordinates that collapse works in.
enum class CollapseSpace { scaled, metric };

template <> struct EnumTable<CollapseSpace> {
  static constexpr EnumRow<CollapseSpace> kRows[] = {
      {CollapseSpace::scaled, "scaled", "the tile as a unit cube"},
      {CollapseSpace::metric, "metric", "metres around the tile's centre"},
  };
};

/// How triangles are chosen. A LevelSpec that is not set means the method's own value for each
/// zoom; simplify/method_specs.h has the names and ranges.
struct MethodOptions {
  std::string name = "greedy"; ///< of the method (simplify/simplifier.h)
  LevelSpec maxError;          ///< metres; not set: from screenError
  LevelSpec screenError{0.5};  ///< pixels

  // greedy
  bool decimate = true;
  ErrorType errorType = ErrorType::height;
  LevelSpec initGrid; ///< cells per edge

  // collapse
  LevelSpec edgeCount; ///< edges left
  LevelSpec edgeRatio; ///< share of edges left, 0..1
  CollapseCost cost = CollapseCost::lindstromTurk;
  CollapseSpace space = CollapseSpace::scaled;
  double volumeWeight = 0.5;
  double boundaryWeight = 0.5;
  LevelSpec shapeWeight;

  // qem
  LevelSpec svo;   ///< metres: the smallest visible object
  LevelSpec ratio; ///< share of vertices left, 0..1

  // quadtree
  LevelSpec curvature;                           ///< cumulated over a cell, no unit
  std::optional<std::array<double, 3>> observer; ///< longitude, latitude (degrees), height (metres)
  double observerRange = 10000;                  ///< metres

  // grid, random, hierarchy, wlop
  LevelSpec borderMaxError;  ///< metres
  LevelSpec borderMaxLength; ///< percent of the tile edge
  double featureAngle = 60;  ///< degrees
  int featureMinSize = 5;    ///< edges of a polyline
  LevelSpec cellSize;        ///< metres
  LevelSpec randomPercent;   ///< percent removed
  LevelSpec clusterSize;     ///< points
  LevelSpec maxVariance;     ///< 0..1/3
  LevelSpec retainPercent;   ///< percent left
  LevelSpec radius;          ///< metres
  int iterations = 35;
};

} // namespace qmesh
