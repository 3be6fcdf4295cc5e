// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <optional>
#include <string>

#include "options/choices.h"

namespace qmesh {

/// What a user can say about how triangles are chosen. Texts called SPEC hold one value per zoom
/// (options/level_spec.h); an empty one means the method's own value for each zoom. The rows of
/// options/method_rows.cpp name each field once.
struct MethodOptions {
  std::string method = "greedy";
  std::string maxError;            ///< SPEC, metres; empty: from screenError
  std::string screenError = "0.5"; ///< SPEC, pixels
  BorderMode border = BorderMode::shared;
  Schedule schedule = Schedule::fourColour; ///< of BorderMode::inherit

  // greedy
  bool decimate = true;
  ErrorType errorType = ErrorType::height;
  std::string initGrid; ///< SPEC, cells per edge

  // collapse
  std::string edgeCount; ///< SPEC, edges left
  std::string edgeRatio; ///< SPEC, share of edges left, 0..1
  CollapseCost cost = CollapseCost::lindstromTurk;
  CollapseSpace space = CollapseSpace::scaled;
  double volumeWeight = 0.5;
  double boundaryWeight = 0.5;
  std::string shapeWeight; ///< SPEC

  // qem
  std::string svo;   ///< SPEC, metres: the smallest visible object
  std::string ratio; ///< SPEC, share of vertices left, 0..1

  // quadtree
  std::string curvature;                         ///< SPEC, cumulated over a cell, no unit
  std::optional<std::array<double, 3>> observer; ///< longitude, latitude (degrees), height (metres)
  double observerRange = 10000;                  ///< metres

  // grid, random, hierarchy, wlop
  std::string borderMaxError;  ///< SPEC, metres
  std::string borderMaxLength; ///< SPEC, percent of the tile edge
  double featureAngle = 60;    ///< degrees
  int featureMinSize = 5;      ///< edges of a polyline
  std::string cellSize;        ///< SPEC, metres
  std::string randomPercent;   ///< SPEC, percent removed
  std::string clusterSize;     ///< SPEC, points
  std::string maxVariance;     ///< SPEC, 0..1/3
  std::string retainPercent;   ///< SPEC, percent left
  std::string radius;          ///< SPEC, metres
  int iterations = 35;
};

} // namespace qmesh
