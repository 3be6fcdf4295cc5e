// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/triangulation.h"

#include <algorithm>
#include <cassert>

namespace qmesh {

namespace {

/// Shape of a counter-clockwise triangle: its doubled area over its longest side squared; <= 0 for
/// others.
double shapeOf(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c) {
  const auto squared = [](const SpanCorner& p, const SpanCorner& q) {
    const double du = p.u - q.u, dv = p.v - q.v;
    return du * du + dv * dv;
  };
  return double(doubledArea(a, b, c)) / std::max({squared(a, b), squared(b, c), squared(c, a)});
}

/// True where d lies inside the circle through the counter-clockwise a, b, c; exact.
bool inCircle(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c, const SpanCorner& d) {
  const std::int64_t au = a.u - d.u, av = a.v - d.v;
  const std::int64_t bu = b.u - d.u, bv = b.v - d.v;
  const std::int64_t cu = c.u - d.u, cv = c.v - d.v;
  const std::int64_t determinant = (au * au + av * av) * (bu * cv - bv * cu) +
                                   (bu * bu + bv * bv) * (cu * av - cv * au) +
                                   (cu * cu + cv * cv) * (au * bv - av * bu);
  return determinant > 0;
}

} // namespace

void Triangulation::reset(const std::array<NodeVertex, 4>& corners) {
  vertices_.assign(corners.begin(), corners.end());
  leaving_.assign(corners.size(), kNone);
  grid_ = {};
  origin_.clear();
  twin_.clear();
  isChanged_.clear();
  changed_.clear();
  const std::int32_t first = newTriangle(), second = newTriangle();
  setTriangle(first, 0, 1, 2);
  setTriangle(second, 0, 2, 3);
  link(3 * first + 2, 3 * second);
}

void Triangulation::reset(const std::vector<NodeVertex>& vertices,
                          const std::vector<TinTriangle>& triangles) {
  vertices_ = vertices;
  leaving_.assign(vertices.size(), kNone);
  grid_ = {};
  origin_.clear();
  twin_.clear();
  isChanged_.clear();
  changed_.clear();
  for (const TinTriangle& t : triangles) {
    const std::int32_t slot = newTriangle();
    setTriangle(slot, std::int32_t(t[0]), std::int32_t(t[1]), std::int32_t(t[2]));
  }
  linkTwins();
}

/// Finds the two half-edges of every edge by the smaller of its vertices.
void Triangulation::linkTwins() {
  std::vector<std::int32_t> last(vertices_.size(), kNone), before(origin_.size(), kNone);
  for (std::int32_t e = 0; e < std::int32_t(origin_.size()); ++e) {
    const std::int32_t a = origin(e), b = destination(e);
    std::int32_t& list = last[std::size_t(std::min(a, b))];
    std::int32_t other = list;
    while (other != kNone && (origin(other) != b || destination(other) != a))
      other = before[std::size_t(other)];
    if (other != kNone)
      link(e, other);
    before[std::size_t(e)] = list;
    list = e;
  }
}

std::int32_t Triangulation::newTriangle() {
  const std::int32_t t = triangleSlots();
  for (int k = 0; k < 3; ++k) {
    origin_.push_back(kNone);
    twin_.push_back(kNone);
  }
  isChanged_.push_back(0);
  return t;
}

void Triangulation::setTriangle(std::int32_t t, std::int32_t a, std::int32_t b, std::int32_t c) {
  const std::int32_t e = 3 * t;
  const std::int32_t corner[3] = {a, b, c};
  for (int k = 0; k < 3; ++k) {
    origin_[std::size_t(e + k)] = corner[k];
    leaving_[std::size_t(corner[k])] = e + k;
  }
  markChanged(t);
}

void Triangulation::markChanged(std::int32_t t) {
  if (isChanged_[std::size_t(t)])
    return;
  isChanged_[std::size_t(t)] = 1;
  changed_.push_back(t);
}

void Triangulation::markAllChanged() {
  for (std::int32_t t = 0; t < triangleSlots(); ++t) {
    if (alive(t))
      markChanged(t);
  }
}

void Triangulation::forgetChanges() {
  for (const std::int32_t t : changed_)
    clearChanged(t);
  changed_.clear();
}

void Triangulation::link(std::int32_t halfEdge, std::int32_t other) {
  twin_[std::size_t(halfEdge)] = other;
  if (other != kNone)
    twin_[std::size_t(other)] = halfEdge;
}

std::int64_t Triangulation::side(std::int32_t halfEdge, const SpanCorner& place) const {
  return doubledArea(vertex(origin(halfEdge)).corner, vertex(origin(next(halfEdge))).corner, place);
}

std::int32_t Triangulation::locate(const SpanCorner& place, std::int32_t hint) const {
  // A walk always ends in a Delaunay triangulation; in another one it might go round in circles.
  std::int32_t t = hint;
  for (std::int32_t steps = triangleSlots(); steps > 0; --steps) {
    std::int32_t across = kNone;
    for (std::int32_t e = 3 * t; e < 3 * t + 3 && across == kNone; ++e) {
      if (side(e, place) < 0)
        across = twin(e);
    }
    if (across == kNone)
      return t;
    t = across / 3;
  }
  return search(place);
}

std::int32_t Triangulation::search(const SpanCorner& place) const {
  for (std::int32_t t = 0; t < triangleSlots(); ++t) {
    if (alive(t) && side(3 * t, place) >= 0 && side(3 * t + 1, place) >= 0 &&
        side(3 * t + 2, place) >= 0)
      return t;
  }
  assert(!"the triangulation covers the square");
  return 0;
}

std::int32_t Triangulation::insert(const NodeVertex& vertex, std::int32_t hint) {
  const std::int32_t t = locate(vertex.corner, hint);
  const auto p = std::int32_t(vertices_.size());
  vertices_.push_back(vertex);
  leaving_.push_back(kNone);
  std::int32_t onEdge = kNone;
  for (std::int32_t e = 3 * t; e < 3 * t + 3; ++e) {
    if (side(e, vertex.corner) == 0)
      onEdge = e;
  }
  if (onEdge == kNone)
    splitTriangle(t, p);
  else
    splitEdge(onEdge, p);
  restoreDelaunay(p);
  return p;
}

void Triangulation::splitTriangle(std::int32_t t, std::int32_t p) {
  const std::int32_t e = 3 * t;
  const std::int32_t a = origin(e), b = origin(e + 1), c = origin(e + 2);
  const std::int32_t beyondB = twin(e + 1), beyondC = twin(e + 2);
  const std::int32_t t1 = newTriangle(), t2 = newTriangle();
  setTriangle(t, a, b, p);
  setTriangle(t1, b, c, p);
  setTriangle(t2, c, a, p);
  link(3 * t1, beyondB);
  link(3 * t2, beyondC);
  link(e + 1, 3 * t1 + 2);
  link(3 * t1 + 1, 3 * t2 + 2);
  link(3 * t2 + 1, e + 2);
  flipStack_.assign({t, t1, t2});
}

void Triangulation::splitEdge(std::int32_t halfEdge, std::int32_t p) {
  const std::int32_t other = twin(halfEdge);
  const std::int32_t t = halfEdge / 3;
  const std::int32_t toC = next(halfEdge), toA = previous(halfEdge);
  const std::int32_t a = origin(halfEdge), b = origin(toC), c = origin(toA);
  const std::int32_t beyondB = twin(toC), beyondC = twin(toA);
  const std::int32_t t1 = newTriangle();
  setTriangle(t, c, a, p);
  setTriangle(t1, b, c, p);
  link(3 * t, beyondC);
  link(3 * t1, beyondB);
  link(3 * t + 2, 3 * t1 + 1);
  flipStack_.assign({t, t1});
  if (other == kNone) {
    link(3 * t + 1, kNone);
    link(3 * t1 + 2, kNone);
    return;
  }
  const std::int32_t s = other / 3;
  const std::int32_t toD = next(other), fromD = previous(other);
  const std::int32_t d = origin(fromD);
  const std::int32_t beyondD = twin(toD), beforeD = twin(fromD);
  const std::int32_t s1 = newTriangle();
  setTriangle(s, a, d, p);
  setTriangle(s1, d, b, p);
  link(3 * s, beyondD);
  link(3 * s1, beforeD);
  link(3 * s + 1, 3 * s1 + 2);
  link(3 * t + 1, 3 * s + 2);
  link(3 * t1 + 2, 3 * s1 + 1);
  flipStack_.push_back(s);
  flipStack_.push_back(s1);
}

void Triangulation::restoreDelaunay(std::int32_t p) {
  const SpanCorner place = vertex(p).corner;
  while (!flipStack_.empty()) {
    const std::int32_t t = flipStack_.back();
    flipStack_.pop_back();
    const std::int32_t other = twin(3 * t);
    if (other == kNone)
      continue;
    const SpanCorner& far = vertex(origin(previous(other))).corner;
    if (inCircle(cornerOf(t, 0).corner, cornerOf(t, 1).corner, place, far) &&
        grid_.mayJoin(place, far))
      flip(t);
  }
}

/// Turns the edge 0 of t = (a, b, p), shared with (b, a, d), into d-p.
void Triangulation::flip(std::int32_t t) {
  const std::int32_t e = 3 * t;
  const std::int32_t other = twin(e);
  const std::int32_t s = other / 3;
  const std::int32_t a = origin(e), b = origin(e + 1), p = origin(e + 2);
  const std::int32_t d = origin(previous(other));
  const std::int32_t beyondA = twin(next(other)), beyondB = twin(previous(other));
  const std::int32_t aroundP = twin(e + 1);
  setTriangle(t, a, d, p);
  setTriangle(s, d, b, p);
  link(e, beyondA);
  link(3 * s, beyondB);
  link(3 * s + 1, aroundP);
  link(e + 1, 3 * s + 2);
  flipStack_.push_back(t);
  flipStack_.push_back(s);
}

void Triangulation::star(std::int32_t v, std::vector<std::int32_t>& halfEdges) const {
  halfEdges.clear();
  std::int32_t first = leaving(v);
  std::int32_t e = first;
  do {
    halfEdges.push_back(e);
    e = twin(previous(e));
  } while (e != first && e != kNone);
  if (e != kNone)
    return;
  while (twin(first) != kNone)
    first = next(twin(first));
  halfEdges.clear();
  for (e = first; e != kNone; e = twin(previous(e)))
    halfEdges.push_back(e);
}

void Triangulation::collapse(std::int32_t v, std::int32_t target) {
  star(v, star_);
  std::size_t at = 0;
  while (destination(star_[at]) != target)
    ++at;
  // The triangles on both sides of the edge v-target vanish: in each, the two other edges become
  // one.
  const std::int32_t leftGone = star_[at], rightGone = next(twin(leftGone));
  link(twin(previous(leftGone)), twin(next(leftGone)));
  link(twin(rightGone), twin(next(rightGone)));
  for (const std::int32_t e : star_) {
    const std::int32_t t = e / 3;
    if (e == leftGone || e == rightGone)
      origin_[std::size_t(3 * t)] = kNone;
    else
      moveCorner(e, target);
  }
  leaving_[std::size_t(v)] = kNone;
}

void Triangulation::remove(std::int32_t v, const std::vector<std::array<std::int32_t, 3>>& fill) {
  star(v, star_);
  beyond_.clear();
  std::vector<std::int32_t> ring;
  for (const std::int32_t e : star_) {
    ring.push_back(destination(e));
    beyond_.push_back(twin(next(e)));
  }
  for (const std::int32_t e : star_)
    origin_[std::size_t(e / 3 * 3)] = kNone;
  for (std::size_t f = 0; f < fill.size(); ++f) {
    setTriangle(star_[f] / 3, ring[std::size_t(fill[f][0])], ring[std::size_t(fill[f][1])],
                ring[std::size_t(fill[f][2])]);
  }
  linkFill(fill);
  leaving_[std::size_t(v)] = kNone;
}

/// Joins the triangles in the first slots of the star to each other and to what is around it.
void Triangulation::linkFill(const std::vector<std::array<std::int32_t, 3>>& fill) {
  const auto corners = std::int32_t(star_.size());
  for (std::size_t f = 0; f < fill.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t e = star_[f] / 3 * 3 + std::int32_t(k);
      const std::int32_t from = fill[f][k], to = fill[f][(k + 1) % 3];
      if (to == (from + 1) % corners) {
        link(e, beyond_[std::size_t(from)]);
        continue;
      }
      for (std::size_t g = 0; g < f; ++g) {
        for (std::size_t l = 0; l < 3; ++l) {
          if (fill[g][l] == to && fill[g][(l + 1) % 3] == from)
            link(e, star_[g] / 3 * 3 + std::int32_t(l));
        }
      }
    }
  }
}

/// Puts the origin of a half-edge onto another vertex.
void Triangulation::moveCorner(std::int32_t halfEdge, std::int32_t target) {
  origin_[std::size_t(halfEdge)] = target;
  const std::int32_t e = halfEdge / 3 * 3;
  setTriangle(halfEdge / 3, origin(e), origin(e + 1), origin(e + 2));
}

/// Turns the corners of a triangle so that a half-edge of it becomes its first.
void Triangulation::turnFirst(std::int32_t halfEdge) {
  const std::int32_t t = halfEdge / 3;
  const std::int32_t second = next(halfEdge), third = previous(halfEdge);
  const std::int32_t corners[3] = {origin(halfEdge), origin(second), origin(third)};
  const std::int32_t twins[3] = {twin(halfEdge), twin(second), twin(third)};
  setTriangle(t, corners[0], corners[1], corners[2]);
  for (int k = 0; k < 3; ++k)
    link(3 * t + k, twins[k]);
}

/// Of the neighbours around a border vertex, which the two beside can do without: place in the star
/// of the one whose triangle with those has the best shape.
std::int32_t Triangulation::bestEar(const std::vector<std::int32_t>& star) const {
  const auto place = [&](std::size_t m) -> const SpanCorner& {
    const std::int32_t e = star[std::min(m, star.size() - 1)];
    return vertex(m < star.size() ? destination(e) : origin(previous(e))).corner;
  };
  const SpanCorner& centre = vertex(origin(star.front())).corner;
  std::int32_t best = kNone;
  double bestShape = 0;
  for (std::size_t m = 1; m < star.size(); ++m) {
    const double shape = shapeOf(place(m - 1), place(m), place(m + 1));
    if (shape > bestShape && doubledArea(centre, place(m - 1), place(m + 1)) > 0) {
      best = std::int32_t(m);
      bestShape = shape;
    }
  }
  return best;
}

void Triangulation::removeBorderVertex(std::int32_t v) {
  std::vector<std::int32_t> around;
  for (star(v, around); around.size() > 2; star(v, around)) {
    // Without v the neighbours are the corners of a polygon, all seen from v: it has an ear there.
    const std::int32_t ear = bestEar(around);
    assert(ear != kNone);
    turnFirst(around[std::size_t(ear)]);
    flip(around[std::size_t(ear)] / 3);
  }
  flipStack_.clear();
  const std::int32_t t = around[0] / 3, gone = around[1] / 3;
  const std::int32_t right = destination(around[0]), top = destination(around[1]);
  const std::int32_t left = origin(previous(around[1]));
  const std::int32_t beyondRight = twin(next(around[0])), beyondLeft = twin(next(around[1]));
  origin_[std::size_t(3 * gone)] = kNone;
  setTriangle(t, left, right, top);
  link(3 * t, kNone);
  link(3 * t + 1, beyondRight);
  link(3 * t + 2, beyondLeft);
  leaving_[std::size_t(v)] = kNone;
}

} // namespace qmesh
