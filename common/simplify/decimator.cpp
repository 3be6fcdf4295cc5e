// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/decimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qmesh {

namespace {

bool isInner(const SpanCorner& corner) {
  return corner.u > 0 && corner.v > 0 && corner.u < kQuantizedMax && corner.v < kQuantizedMax;
}

/// True where the rounding of a vertex's place, half a unit in u and in v, is worth more height
/// than the tolerance has to spare: three quarters, as a border's rounding may take the last one.
/// Such are the slivers between nodes of one line.
bool isTooSteep(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c, float tolerance) {
  const double bu = b.u - a.u, bv = b.v - a.v, bh = b.height - a.height;
  const double cu = c.u - a.u, cv = c.v - a.v, ch = c.height - a.height;
  const double rise = std::abs(bh * cv - ch * bv) + std::abs(ch * bu - bh * cu);
  return 0.5 * rise > 0.75 * double(tolerance) * (bu * cv - bv * cu);
}

} // namespace

int Decimator::run(Triangulation& mesh, NodeHeights& heights, int keptCells, float tolerance) {
  int removed = 0;
  for (std::int32_t v = 0; v < std::int32_t(mesh.vertices().size()); ++v) {
    const NodeVertex& vertex = mesh.vertex(v);
    const bool kept = vertex.i % keptCells == 0 && vertex.j % keptCells == 0;
    if (!kept && isInner(vertex.corner) && mesh.leaving(v) != Triangulation::kNone)
      removed += tryRemove(mesh, heights, v, tolerance) ? 1 : 0;
  }
  return removed;
}

bool Decimator::removeAny(Triangulation& mesh, NodeHeights& heights) {
  for (std::int32_t v = 0; v < std::int32_t(mesh.vertices().size()); ++v) {
    if (isInner(mesh.vertex(v).corner) && mesh.leaving(v) != Triangulation::kNone &&
        tryRemove(mesh, heights, v, std::numeric_limits<float>::infinity()))
      return true;
  }
  return false;
}

bool Decimator::tryRemove(Triangulation& mesh, NodeHeights& heights, std::int32_t v,
                          float tolerance) {
  readRing(mesh, v);
  const SpanCorner& node = mesh.vertex(v).corner;
  targets_.clear();
  for (std::size_t m = 0; m < ring_.size(); ++m) {
    if (!isVisible(m))
      continue;
    const float error = errorAtNode(m, node);
    if (error <= tolerance)
      targets_.push_back({error, int(m)});
  }
  // The best fit first: most of them pass, so that one scan is enough.
  std::sort(targets_.begin(), targets_.end(), [](const Target& a, const Target& b) {
    return a.error != b.error ? a.error < b.error : a.ringIndex < b.ringIndex;
  });
  const std::int32_t index = heights.index(mesh.vertex(v).i, mesh.vertex(v).j);
  heights.unmask(index);
  for (const Target& target : targets_) {
    if (isWithin(heights, std::size_t(target.ringIndex), tolerance)) {
      mesh.collapse(v, ring_[std::size_t(target.ringIndex)]);
      return true;
    }
  }
  heights.mask(index);
  return false;
}

void Decimator::readRing(const Triangulation& mesh, std::int32_t v) {
  mesh.star(v, star_);
  ring_.clear();
  corners_.clear();
  for (const std::int32_t e : star_) {
    ring_.push_back(mesh.destination(e));
    corners_.push_back(mesh.vertex(ring_.back()).corner);
  }
}

/// True where corner m of the ring sees all others: the fan of triangles from it is one of
/// counter-clockwise ones. They fill the ring exactly, so none of their edges exists elsewhere and
/// the mesh stays manifold.
bool Decimator::isVisible(std::size_t m) const {
  const std::size_t count = corners_.size();
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const SpanCorner& a = corners_[(m + k) % count];
    const SpanCorner& b = corners_[(m + k + 1) % count];
    if (doubledArea(corners_[m], a, b) <= 0)
      return false;
  }
  return true;
}

/// How far the fan from corner m is from the vertex it would replace, metres.
float Decimator::errorAtNode(std::size_t m, const SpanCorner& node) const {
  const std::size_t count = corners_.size();
  const SpanCorner& apex = corners_[m];
  std::size_t k = 1;
  while (k + 2 < count && doubledArea(apex, corners_[(m + k + 1) % count], node) > 0)
    ++k;
  const SpanCorner& a = corners_[(m + k) % count];
  const SpanCorner& b = corners_[(m + k + 1) % count];
  const double height = planeHeight(apex, a, b, node);
  return float(std::abs(height - node.height));
}

bool Decimator::isWithin(const NodeHeights& heights, std::size_t m, float tolerance) const {
  const std::size_t count = corners_.size();
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const SpanCorner& a = corners_[(m + k) % count];
    const SpanCorner& b = corners_[(m + k + 1) % count];
    if (isTooSteep(corners_[m], a, b, tolerance) ||
        heights.worst(corners_[m], a, b, tolerance).node >= 0)
      return false;
  }
  return true;
}

} // namespace qmesh
