// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/exact_refinement.h"

#include <algorithm>
#include <cmath>

namespace qmesh {

namespace {

/// Relative difference of two ways to compute one error.
constexpr double kRoundingSlack = 1e-9;

/// The bits of a node with a vertex at each of its four places.
constexpr std::uint8_t kAllPlaces = 15;
constexpr std::uint8_t kEastPlaces = 10;  ///< the two to the east of the node
constexpr std::uint8_t kNorthPlaces = 12; ///< the two to the north

} // namespace

void ExactRefinement::reset(const HeightTile& tile, const TileFrame& frame, double maxError) {
  tile_ = &tile;
  frame_ = &frame;
  maxError_ = maxError;
  distance_ = {};
  isFree_ = {};
  severalPlaces_ = frame.heightStep() <= maxError; // else rounded heights are in the way
  nodeV_.clear();
  for (int j = 0; j <= frame.cells(); ++j)
    nodeV_.push_back(frame.nodeV(j));
  nodeV_.resize(nodeV_.size() + kLanePadding, kQuantizedMax);
}

ErrorMeasure ExactRefinement::run(NodeMesh& nodes, Tin& out) {
  Triangulation& mesh = nodes.triangulation();
  while (true) {
    nodes.write(out);
    const ErrorMeasure measure = measureError(*tile_, *frame_, out);
    if (measure.max <= maxError_)
      return measure;
    mesh.markAllChanged();
    countPlaces(mesh);
    const double tolerance = maxError_ * (1 - kRoundingSlack);
    const bool inserted = rounds_.run(
        mesh, [&](std::int32_t t) { return worstOf(mesh, t, tolerance); },
        [&](const Candidate& candidate) { return insertAtFreePlace(nodes, candidate); });
    if (!inserted)
      return measure;
  }
}

bool ExactRefinement::insertWorst(NodeMesh& nodes) {
  const Triangulation& mesh = nodes.triangulation();
  countPlaces(mesh);
  Candidate worst{~std::uint64_t(0), -1, 0};
  for (std::int32_t t = 0; t < mesh.triangleSlots(); ++t) {
    const NodeError found = mesh.alive(t) ? worstOf(mesh, t, -1) : NodeError{};
    if (found.node >= 0)
      worst = std::min(worst, makeCandidate(found, t));
  }
  return worst.node >= 0 && insertAtFreePlace(nodes, worst);
}

/// Makes a node a vertex, or gives one that is another vertex, at the nearest free of the four
/// quantized places around its real position. With all four it lies on a level square, whatever the
/// slopes around: so rounding of places never keeps a node from the max error. A node of an edge
/// has the two on the edge, as in the border contract. False where none is free.
bool ExactRefinement::insertAtFreePlace(NodeMesh& nodes, const Candidate& candidate) {
  const int across = frame_->cells() + 1;
  const int i = candidate.node % across, j = candidate.node / across;
  std::uint8_t& used = places_[std::size_t(candidate.node)];
  const int west = int(frame_->nodeU(i)), south = int(frame_->nodeV(j));
  const double du = frame_->nodeU(i) - west, dv = frame_->nodeV(j) - south;
  int best = -1;
  double nearest = 0;
  for (int place = 0; place < 4; ++place) {
    const int east = place & 1, north = place >> 1;
    const double distance = std::abs(du - east) + std::abs(dv - north);
    if ((used >> place & 1) == 0 && (best < 0 || distance < nearest)) {
      best = place;
      nearest = distance;
    }
  }
  if (best < 0)
    return false;
  used = severalPlaces_ ? std::uint8_t(used | 1 << best) : kAllPlaces;
  nodes.triangulation().insert(nodes.makeVertex(i, j, west + (best & 1), south + (best >> 1)),
                               candidate.triangle);
  return true;
}

/// Which places the vertices of the mesh take; one away from the places of its node takes none.
void ExactRefinement::countPlaces(const Triangulation& mesh) {
  const int n = frame_->cells();
  places_.assign(std::size_t(index(n, n)) + 1, 0);
  for (int k = 0; k <= n; ++k) { // what is not on the edge itself is no place of its nodes
    places_[std::size_t(index(0, k))] |= kEastPlaces;
    places_[std::size_t(index(n, k))] |= kEastPlaces;
    places_[std::size_t(index(k, 0))] |= kNorthPlaces;
    places_[std::size_t(index(k, n))] |= kNorthPlaces;
  }
  for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
    if (mesh.leaving(std::int32_t(v)) == Triangulation::kNone)
      continue;
    const NodeVertex& vertex = mesh.vertices()[v];
    const int east = vertex.corner.u - int(frame_->nodeU(vertex.i));
    const int north = vertex.corner.v - int(frame_->nodeV(vertex.j));
    if ((east | north) >> 1 != 0)
      continue;
    std::uint8_t& used = places_[std::size_t(index(vertex.i, vertex.j))];
    used = severalPlaces_ ? std::uint8_t(used | 1 << (2 * north + east)) : kAllPlaces;
  }
}

/// Inner nodes and those of free edges.
bool ExactRefinement::mayBecomeVertex(int i, int j) const {
  const int n = frame_->cells();
  return (i > 0 || isFree_[kWest]) && (j > 0 || isFree_[kSouth]) && (i < n || isFree_[kEast]) &&
         (j < n || isFree_[kNorth]);
}

/// The node of a triangle with the largest error above the tolerance, in the arithmetic of
/// measureError(); one with all its places taken has no say.
NodeError ExactRefinement::worstOf(const Triangulation& mesh, std::int32_t t,
                                   double tolerance) const {
  SpanCorner corners[3];
  for (int k = 0; k < 3; ++k) {
    corners[k] = mesh.cornerOf(t, k).corner;
    corners[k].height = frame_->decode(mesh.cornerOf(t, k).q);
  }
  const int cells = frame_->cells();
  const double slope = heightPerColumn(corners[0], corners[1], corners[2], unitsPerColumn(cells));
  listSpans(corners[0], corners[1], corners[2], nodeV_.data(), slope, *spans_);
  NodeError found;
  const double perDistance = distance_.heightPerDistance(corners[0], corners[1], corners[2]);
  double worst = tolerance * perDistance;
  for (int r = 0; r < spans_->rows; ++r) {
    const int j = spans_->firstRow + r;
    for (int i = spans_->begin[r]; i < spans_->begin[r] + spans_->count[r]; ++i) {
      const double error =
          std::abs(spans_->height[r] + (i - spans_->begin[r]) * slope - tile_->at(i, j));
      if (error > worst && mayBecomeVertex(i, j) &&
          places_[std::size_t(index(i, j))] != kAllPlaces) {
        worst = error;
        found = {index(i, j), float(error / perDistance)};
      }
    }
  }
  return found;
}

} // namespace qmesh
