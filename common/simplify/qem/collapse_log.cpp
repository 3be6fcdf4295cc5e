// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/qem/collapse_log.h"

#include <algorithm>
#include <cassert>

namespace qmesh {

namespace {

std::array<std::int32_t, 3> cornersOf(const Triangulation& mesh, std::int32_t t) {
  return {mesh.origin(3 * t), mesh.origin(3 * t + 1), mesh.origin(3 * t + 2)};
}

} // namespace

void CollapseLog::clear() {
  steps_.clear();
  changed_.clear();
}

void CollapseLog::record(const Triangulation& mesh, std::int32_t vertex, std::int32_t target,
                         double error) {
  CollapseStep step;
  step.vertex = vertex;
  step.target = target;
  step.error = error;
  step.firstChanged = changed_.size();
  mesh.star(vertex, star_);
  std::size_t gone = 0;
  for (const std::int32_t e : star_) {
    const bool vanishes =
        mesh.destination(e) == target || mesh.origin(Triangulation::previous(e)) == target;
    if (!vanishes) {
      changed_.push_back(e / 3);
      continue;
    }
    assert(gone < step.removed.size());
    step.removed[gone] = e / 3;
    step.removedCorners[gone] = cornersOf(mesh, e / 3);
    ++gone;
  }
  steps_.push_back(step);
}

DetailCursor::DetailCursor(const CollapseLog& log, const Triangulation& simplest)
    : log_(log), done_(log.steps().size()) {
  for (std::int32_t t = 0; t < simplest.triangleSlots(); ++t)
    triangles_.push_back(simplest.alive(t) ? cornersOf(simplest, t) : kGone);
}

void DetailCursor::moveTo(std::size_t steps) {
  assert(steps <= log_.steps().size());
  while (done_ < steps)
    redo();
  while (done_ > steps)
    undo();
}

void DetailCursor::redo() {
  const CollapseStep& step = log_.steps()[done_];
  for (std::size_t k = log_.changedBegin(done_); k < log_.changedEnd(done_); ++k) {
    auto& corners = triangles_[std::size_t(log_.changed()[k])];
    std::replace(corners.begin(), corners.end(), step.vertex, step.target);
  }
  for (const std::int32_t t : step.removed)
    triangles_[std::size_t(t)] = kGone;
  ++done_;
}

void DetailCursor::undo() {
  --done_;
  const CollapseStep& step = log_.steps()[done_];
  for (std::size_t k = 0; k < step.removed.size(); ++k)
    triangles_[std::size_t(step.removed[k])] = step.removedCorners[k];
  for (std::size_t k = log_.changedBegin(done_); k < log_.changedEnd(done_); ++k) {
    auto& corners = triangles_[std::size_t(log_.changed()[k])];
    std::replace(corners.begin(), corners.end(), step.target, step.vertex);
  }
}

} // namespace qmesh
