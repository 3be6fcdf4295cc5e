// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/qem/edge_collapser.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace qmesh {

namespace {

Vec3 crossProduct(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The lowest bit of a number in which it has a one; 10 for 0 and for multiples of 1024.
std::uint32_t lowestBit(std::uint32_t number) {
  std::uint32_t bit = 0;
  while (bit < 10 && (number >> bit & 1) == 0)
    ++bit;
  return bit;
}

/// Of equal costs the nodes of the finest grid go first, from the middles of its cells, then those
/// of the next coarser one: on level ground vertices thin out evenly, and none gathers a long row
/// of others.
std::vector<std::uint32_t> ranks(const Triangulation& mesh) {
  std::vector<std::uint32_t> ranks;
  for (const NodeVertex& vertex : mesh.vertices()) {
    const std::uint32_t i = lowestBit(vertex.i), j = lowestBit(vertex.j);
    const std::uint32_t level = 2 * std::min(i, j) + (i == j ? 0 : 1);
    ranks.push_back(level << 24 | std::uint32_t(ranks.size()));
  }
  return ranks;
}

} // namespace

void EdgeCollapser::reset(Triangulation& mesh, const MetricScale& scale,
                          const std::vector<std::uint8_t>& stays, const BaseGrid& grid,
                          CollapseLog* log) {
  mesh_ = &mesh;
  log_ = log;
  if (log)
    log->clear();
  stays_ = stays;
  grid_ = grid;
  points_.clear();
  constexpr double middle = kQuantizedMax / 2.0;
  for (const NodeVertex& vertex : mesh.vertices())
    points_.push_back({(vertex.corner.u - middle) * scale.east,
                       (vertex.corner.v - middle) * scale.north, vertex.corner.height});
  vertices_ = points_.size();
  errorSum_ = errorRest_ = 0;
  addQuadrics();
  heap_.reset(ranks(mesh));
  target_.assign(points_.size(), Triangulation::kNone);
  for (std::int32_t v = 0; v < std::int32_t(points_.size()); ++v) {
    if (!stays_[std::size_t(v)])
      heap_.set(v, 0); // less it cannot cost; to be found out when it comes to the top
  }
}

/// Every vertex begins with the planes of its triangles.
void EdgeCollapser::addQuadrics() {
  quadrics_.assign(points_.size(), {});
  for (std::int32_t t = 0; t < mesh_->triangleSlots(); ++t) {
    const std::int32_t a = mesh_->origin(3 * t), b = mesh_->origin(3 * t + 1),
                       c = mesh_->origin(3 * t + 2);
    const Vec3 normal = normalized(crossProduct(point(b) - point(a), point(c) - point(a)));
    const double offset = -dot(normal, point(a));
    for (const std::int32_t corner : {a, b, c})
      quadrics_[std::size_t(corner)].addPlane(normal, offset);
  }
  ownError_.clear();
  for (std::size_t v = 0; v < points_.size(); ++v)
    ownError_.push_back(quadrics_[v].at(points_[v]));
}

double EdgeCollapser::meanError(std::int32_t v) const {
  return ownError_[std::size_t(v)] / quadric(v).planes;
}

/// Error of the sum of two quadrics where the target stands.
double EdgeCollapser::costOf(std::int32_t v, std::int32_t target) const {
  return quadric(v).at(point(target)) + ownError_[std::size_t(target)];
}

/// Neumaier's sum: what comes and goes leaves nothing behind.
void EdgeCollapser::addToSum(double value) {
  const double sum = errorSum_ + value;
  errorRest_ += std::abs(errorSum_) >= std::abs(value) ? (errorSum_ - sum) + value
                                                       : (value - sum) + errorSum_;
  errorSum_ = sum;
}

double EdgeCollapser::svo() const {
  const double sum = errorSum_ + errorRest_;
  return sum > 0 ? std::sqrt(sum / double(vertices_)) : 0;
}

void EdgeCollapser::readRing(std::int32_t v) {
  mesh_->star(v, star_);
  const SpanCorner& centre = mesh_->vertex(v).corner;
  ring_.clear();
  for (const std::int32_t e : star_) {
    const std::int32_t end = mesh_->destination(e);
    const SpanCorner& corner = mesh_->vertex(end).corner;
    ring_.push_back(
        {end, corner.u - centre.u, corner.v - centre.v, costOf(v, end), heap_.rank(end)});
  }
}

/// True where the fan of triangles from neighbour m fills the ring, all counter-clockwise and of
/// edges that the grid permits.
bool EdgeCollapser::seesRing(std::size_t m) const {
  const Neighbour& apex = ring_[m];
  const auto after = [&](std::size_t k) { return k + 1 < ring_.size() ? k + 1 : 0; };
  std::size_t a = after(m);
  for (std::size_t b = after(a); b != m; a = b, b = after(b)) {
    // With the vertex as origin, doubled areas are sums of cross products.
    if (std::int64_t(cross(ring_[a], ring_[b])) - cross(apex, ring_[b]) + cross(apex, ring_[a]) <=
        0)
      return false;
    const std::int64_t u = ring_[a].u - apex.u, v = ring_[a].v - apex.v;
    if (!grid_.isShort(u * u + v * v))
      return false;
  }
  return true;
}

/// Finds the best neighbour to move a vertex onto.
void EdgeCollapser::evaluate(std::int32_t v) {
  if (stays_[std::size_t(v)])
    return;
  readRing(v);
  order_.resize(ring_.size());
  std::iota(order_.begin(), order_.end(), 0);
  const auto isWorse = [&](std::int32_t a, std::int32_t b) {
    return ring_[std::size_t(b)].isBetter(ring_[std::size_t(a)]);
  };
  std::make_heap(order_.begin(), order_.end(), isWorse);
  for (; !order_.empty(); order_.pop_back()) {
    const auto best = std::size_t(order_.front());
    if (seesRing(best)) {
      target_[std::size_t(v)] = ring_[best].vertex;
      heap_.set(v, ring_[best].cost);
      return;
    }
    std::pop_heap(order_.begin(), order_.end(), isWorse);
  }
  heap_.remove(v);
}

bool EdgeCollapser::findNext() {
  while (!heap_.empty()) {
    const std::int32_t v = heap_.top();
    if (target_[std::size_t(v)] != Triangulation::kNone)
      return true;
    evaluate(v);
  }
  return false;
}

double EdgeCollapser::nextSvo() const {
  const std::int32_t v = heap_.top(), target = target_[std::size_t(v)];
  const double merged = heap_.cost(v) / (quadric(v).planes + quadric(target).planes);
  const double sum = errorSum_ + errorRest_ - meanError(v) - meanError(target) + merged;
  return sum > 0 ? std::sqrt(sum / double(vertices_ - 1)) : 0;
}

/// A neighbour of the target of a collapse: what it sees has changed.
void EdgeCollapser::touch(std::int32_t v, std::int32_t target) {
  if (stays_[std::size_t(v)])
    return;
  target_[std::size_t(v)] = Triangulation::kNone;
  const double cost = costOf(v, target);
  if (!heap_.contains(v) || cost < heap_.cost(v))
    heap_.set(v, cost);
}

void EdgeCollapser::collapse() {
  const std::int32_t v = heap_.top(), target = target_[std::size_t(v)];
  const double error = heap_.cost(v);
  heap_.remove(v);
  if (log_)
    log_->record(*mesh_, v, target, error);
  mesh_->collapse(v, target);
  --vertices_;
  addToSum(-meanError(v));
  addToSum(-meanError(target));
  quadrics_[std::size_t(target)].add(quadric(v));
  ownError_[std::size_t(target)] = quadric(target).at(point(target));
  addToSum(meanError(target));
  mesh_->star(target, star_);
  for (const std::int32_t e : star_)
    touch(mesh_->destination(e), target);
  touch(mesh_->origin(Triangulation::previous(star_.back())), target);
  evaluate(target);
  if (log_)
    log_->setSvo(svo());
}

} // namespace qmesh
