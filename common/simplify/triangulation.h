// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/base_grid.h"
#include "mesh/tin.h"
#include "mesh/triangle_spans.h"

namespace qmesh {

/// A vertex of a triangulation under construction: a node of the tile.
struct NodeVertex {
  SpanCorner corner;   ///< height: the quantized one above the frame's minimum, metres
  std::uint16_t q = 0; ///< quantized height
  std::uint16_t i = 0; ///< node column
  std::uint16_t j = 0; ///< node row
};

/// Triangulation of the square 0..32767 squared, counter-clockwise, in flat arrays that keep their
/// memory from tile to tile. Insertion flips edges until they are Delaunay (Lawson 1977). All
/// predicates are exact in 64-bit integers: with |coordinates| <= 32767 = L the in-circle
/// determinant is a sum of three products of a squared distance (<= 2 L^2) and a doubled area
/// (<= L^2), so it stays below 6 L^4 < 2^63.
///
/// Half-edge e = 3 t + k runs from corner k of triangle t to the next one.
class Triangulation {
 public:
  static constexpr std::int32_t kNone = -1;

  /// Starts again with two triangles over the four corners, given counter-clockwise from the
  /// south-west.
  void reset(const std::array<NodeVertex, 4>& corners);

  /// Takes over a triangulation made elsewhere. REQUIRES: it covers the square, its triangles are
  /// counter-clockwise.
  void reset(const std::vector<NodeVertex>& vertices, const std::vector<TinTriangle>& triangles);

  /// Until the next reset() insertion flips no edge into one that is longer than the grid permits:
  /// a mesh of shorter ones that is not Delaunay keeps to it as well. DEFAULT: no limit.
  void limitFlips(const BaseGrid& grid) { grid_ = grid; }

  /// Adds a vertex in the triangle that holds it; the search begins at `hint`.
  /// REQUIRES: no vertex at its place; it lies within the square. Returns its index.
  std::int32_t insert(const NodeVertex& vertex, std::int32_t hint);

  /// The triangle that holds a place of the square; the search begins at `hint`.
  std::int32_t locate(const SpanCorner& place, std::int32_t hint) const;

  /// Takes an inner vertex away by moving it onto its neighbour `target`.
  /// REQUIRES: every triangle that keeps two other corners of its star stays counter-clockwise.
  void collapse(std::int32_t vertex, std::int32_t target);

  /// Takes an inner vertex away and fills its star with other triangles, counter-clockwise and
  /// given as indices of star()'s half-edges: each stands for the vertex at its end.
  /// REQUIRES: they cover the star.
  void remove(std::int32_t vertex, const std::vector<std::array<std::int32_t, 3>>& fill);

  /// Takes away a vertex of the square's edges that is no corner: edges are flipped until two
  /// triangles are left to it, best shapes first, and those become one.
  void removeBorderVertex(std::int32_t vertex);

  /// The half-edges that leave a vertex, counter-clockwise. At a vertex of the square's edges they
  /// begin with the one on the edge; the neighbour behind the last one is that one's previous
  /// origin.
  void star(std::int32_t vertex, std::vector<std::int32_t>& halfEdges) const;

  /// Slots of triangles ever made; those of collapsed ones are not alive.
  std::int32_t triangleSlots() const { return std::int32_t(origin_.size() / 3); }
  bool alive(std::int32_t t) const { return origin_[std::size_t(3 * t)] != kNone; }
  std::int32_t origin(std::int32_t halfEdge) const { return origin_[std::size_t(halfEdge)]; }
  std::int32_t destination(std::int32_t halfEdge) const { return origin(next(halfEdge)); }
  std::int32_t twin(std::int32_t halfEdge) const { return twin_[std::size_t(halfEdge)]; }
  static std::int32_t next(std::int32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static std::int32_t previous(std::int32_t e) { return e % 3 == 0 ? e + 2 : e - 1; }

  const std::vector<NodeVertex>& vertices() const { return vertices_; }
  const NodeVertex& vertex(std::int32_t v) const { return vertices_[std::size_t(v)]; }
  const NodeVertex& cornerOf(std::int32_t t, int k) const { return vertex(origin(3 * t + k)); }
  /// A half-edge that leaves the vertex, kNone where it was collapsed.
  std::int32_t leaving(std::int32_t v) const { return leaving_[std::size_t(v)]; }

  /// The triangles made or changed since the list was last taken, each once.
  std::vector<std::int32_t>& changed() { return changed_; }
  bool isChanged(std::int32_t t) const { return isChanged_[std::size_t(t)] != 0; }
  void clearChanged(std::int32_t t) { isChanged_[std::size_t(t)] = 0; }
  void markChanged(std::int32_t t);
  void markAllChanged();
  void forgetChanges();

 private:
  std::int32_t search(const SpanCorner& place) const;
  std::int64_t side(std::int32_t halfEdge, const SpanCorner& place) const;
  std::int32_t newTriangle();
  void setTriangle(std::int32_t t, std::int32_t a, std::int32_t b, std::int32_t c);
  void link(std::int32_t halfEdge, std::int32_t other);
  void splitTriangle(std::int32_t t, std::int32_t p);
  void splitEdge(std::int32_t halfEdge, std::int32_t p);
  void linkTwins();
  void restoreDelaunay(std::int32_t p);
  void flip(std::int32_t t);
  void linkFill(const std::vector<std::array<std::int32_t, 3>>& fill);
  void turnFirst(std::int32_t halfEdge);
  std::int32_t bestEar(const std::vector<std::int32_t>& star) const;
  void moveCorner(std::int32_t halfEdge, std::int32_t target);

  BaseGrid grid_;
  std::vector<NodeVertex> vertices_;
  std::vector<std::int32_t> leaving_;
  std::vector<std::int32_t> origin_;
  std::vector<std::int32_t> twin_;
  std::vector<std::uint8_t> isChanged_;
  std::vector<std::int32_t> changed_;
  std::vector<std::int32_t> flipStack_; ///< triangles whose edge 0 faces the new vertex
  std::vector<std::int32_t> star_;
  std::vector<std::int32_t> beyond_; ///< half-edges around a star
};

} // namespace qmesh
