// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "simplify/triangulation.h"

namespace qmesh {

/// One half-edge collapse.
struct CollapseStep {
  std::int32_t vertex = 0; ///< went
  std::int32_t target = 0; ///< onto this one, which stayed where it is
  double error = 0;        ///< quadric error of the target with all it stands for now, m2
  double svo = 0;          ///< smallest visible object of the mesh after the step, metres
  /// The two triangles that vanished, and their corners as they were.
  std::array<std::int32_t, 2> removed{};
  std::array<std::array<std::int32_t, 3>, 2> removedCorners{};
  std::size_t firstChanged = 0; ///< in CollapseLog::changed(); ends where the next step's begin
};

/// The detail increments between a full mesh and its simplest version (Ai et al. 2019, section
/// 2.2), in the order in which the details went. Triangles and vertices keep their numbers.
class CollapseLog {
 public:
  void clear();

  /// Writes down what moving `vertex` onto `target` will do to the mesh.
  /// REQUIRES: the collapse has not happened yet, and is the next one to happen.
  void record(const Triangulation& mesh, std::int32_t vertex, std::int32_t target, double error);
  /// Completes the last step.
  void setSvo(double metres) { steps_.back().svo = metres; }

  const std::vector<CollapseStep>& steps() const { return steps_; }

  /// The triangles of step k whose corner `vertex` became `target`: from..to-1 of changed().
  std::size_t changedBegin(std::size_t k) const { return steps_[k].firstChanged; }
  std::size_t changedEnd(std::size_t k) const {
    return k + 1 < steps_.size() ? steps_[k + 1].firstChanged : changed_.size();
  }
  const std::vector<std::int32_t>& changed() const { return changed_; }

 private:
  std::vector<CollapseStep> steps_;
  std::vector<std::int32_t> changed_;
  std::vector<std::int32_t> star_;
};

/// The triangles of a mesh at any state of its log: forwards to simpler versions, backwards to
/// fuller ones. REQUIRES: the log lives as long and does not grow.
class DetailCursor {
 public:
  static constexpr std::array<std::int32_t, 3> kGone = {-1, -1, -1};

  /// Begins at the simplest version, the mesh as the log's last step left it.
  DetailCursor(const CollapseLog& log, const Triangulation& simplest);

  /// Steps of the log that are done: 0 is the full mesh.
  std::size_t stepsDone() const { return done_; }
  void moveTo(std::size_t steps);

  /// Corners by triangle, kGone for those the version does not have.
  const std::vector<std::array<std::int32_t, 3>>& triangles() const { return triangles_; }

 private:
  void redo();
  void undo();

  const CollapseLog& log_;
  std::size_t done_;
  std::vector<std::array<std::int32_t, 3>> triangles_;
};

} // namespace qmesh
