// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "../mesh/terrain.h"
#include "simplify/simplifier.h"

namespace qmesh::test {

/// REQUIRES: `text` is a SPEC, or empty: not set.
inline LevelSpec spec(const std::string& text) {
  return text.empty() ? LevelSpec() : *LevelSpec::parse(text);
}

/// A tile with all that was made of it.
struct Simplified {
  LevelParams level;
  TileFrame frame;
  Border border;
  Tin tin;
};

inline Simplified simplify(const HeightTile& tile, const LevelParams& level,
                           Simplifier& simplifier) {
  Simplified made;
  made.level = level;
  made.frame.reset(tile, level);
  simplifier.makeBorder(tile, made.frame, level, made.border);
  EXPECT_TRUE(simplifier.simplify(tile, made.frame, made.border, level, made.tin).ok());
  return made;
}

inline Simplified simplify(const HeightTile& tile, const LevelParams& level, bool decimate = true,
                           const char* method = "greedy") {
  MethodOptions options;
  options.decimate = decimate;
  const auto simplifier = findSimplifier(method)->create(options);
  return simplify(tile, level, *simplifier);
}

/// The nodes (i, j) whose vertices lie inside the square.
inline std::set<std::pair<int, int>> innerNodes(const Simplified& made) {
  std::set<std::pair<int, int>> nodes;
  const int n = made.frame.cells();
  for (const TinVertex& vertex : made.tin.vertices) {
    const int i = made.frame.nearestColumn(vertex.u), j = made.frame.nearestRow(vertex.v);
    const bool border = i == 0 || j == 0 || i == n || j == n;
    if (!border)
      nodes.insert({i, j});
  }
  return nodes;
}

/// The places (u, v) of the vertices on the square's edges.
inline std::set<std::pair<int, int>> borderPlaces(const Simplified& made) {
  std::set<std::pair<int, int>> places;
  for (const TinVertex& vertex : made.tin.vertices) {
    const auto atEnd = [](int p) { return p == 0 || p == kQuantizedMax; };
    if (atEnd(vertex.u) || atEnd(vertex.v))
      places.insert({vertex.u, vertex.v});
  }
  return places;
}

/// The same as the border has them.
inline std::set<std::pair<int, int>> placesOf(const Border& border) {
  std::set<std::pair<int, int>> places;
  for (const int k : border[kWest])
    places.insert({0, k});
  for (const int k : border[kSouth])
    places.insert({k, 0});
  for (const int k : border[kEast])
    places.insert({kQuantizedMax, k});
  for (const int k : border[kNorth])
    places.insert({k, kQuantizedMax});
  return places;
}

inline bool same(const Tin& a, const Tin& b) {
  const auto sameVertex = [](const TinVertex& x, const TinVertex& y) {
    return x.u == y.u && x.v == y.v && x.q == y.q;
  };
  return a.triangles == b.triangles && a.vertices.size() == b.vertices.size() &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), sameVertex) &&
         a.maxError == b.maxError && a.sumSquaredError == b.sumSquaredError && a.reason == b.reason;
}

} // namespace qmesh::test
