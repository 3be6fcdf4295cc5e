// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "border/border.h"

namespace qmesh {

/// One edge as a profile: its nodes in ascending order.
struct EdgeProfile {
  const float* heights;
  std::ptrdiff_t stride;
  const TileFrame& frame;
  bool alongRow; ///< south and north edges run along u
  double step;   ///< S of the level, not the coarser one of a tile: the neighbour has another

  double place(int node) const { return alongRow ? frame.nodeU(node) : frame.nodeV(node); }
  int nearestPlace(int node) const { return alongRow ? frame.u(node) : frame.v(node); }
  double height(int node) const { return heights[node * stride]; }
  double vertexHeight(int node) const { return roundToLattice(height(node), step); }
};

EdgeProfile edgeProfile(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                        Edge edge);

/// True for the edge that is one point of the globe.
bool isPoleEdge(const HeightTile& tile, Edge edge);

/// What the nodes of an edge may be off by, metres: the max error, or what rounding to the lattice
/// costs.
double borderTolerance(const LevelParams& level);

/// A vertex of an edge: a node at one of the two places around its position.
struct EdgeVertex {
  int node;
  int place;
};

struct WorstOfEdge {
  EdgeVertex vertex{-1, 0}; ///< what to insert
  double error = -1;        ///< metres
};

/// The node whose position lies between two vertices and that is farthest from the line between
/// them. That may be the node of one of the two: then its other place goes in.
WorstOfEdge worstBetween(const EdgeProfile& profile, const EdgeVertex& a, const EdgeVertex& b);

/// Appends the places within a..b, b excluded, in ascending order: those that keep every node
/// between within the tolerance, the worst node first.
void splitLine(const EdgeProfile& profile, const EdgeVertex& a, const EdgeVertex& b,
               double tolerance, std::vector<std::uint16_t>& places);

} // namespace qmesh
