// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/triangulation.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "mesh/check.h"

namespace qmesh {
namespace {

__extension__ using Wide = __int128;

NodeVertex at(int u, int v) {
  NodeVertex vertex;
  vertex.corner.u = u;
  vertex.corner.v = v;
  return vertex;
}

void startSquare(Triangulation& mesh) {
  constexpr int m = kQuantizedMax;
  mesh.reset({at(0, 0), at(m, 0), at(m, m), at(0, m)});
}

Tin tinOf(const Triangulation& mesh) {
  Tin tin;
  std::vector<std::uint32_t> index;
  for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
    index.push_back(std::uint32_t(tin.vertices.size()));
    const SpanCorner& corner = mesh.vertices()[v].corner;
    if (mesh.leaving(std::int32_t(v)) != Triangulation::kNone)
      tin.vertices.push_back({std::uint16_t(corner.u), std::uint16_t(corner.v), 0});
  }
  for (std::int32_t t = 0; t < mesh.triangleSlots(); ++t) {
    if (mesh.alive(t))
      tin.triangles.push_back({index[std::size_t(mesh.origin(3 * t))],
                               index[std::size_t(mesh.origin(3 * t + 1))],
                               index[std::size_t(mesh.origin(3 * t + 2))]});
  }
  return tin;
}

void expectConsistent(const Triangulation& mesh) {
  for (std::int32_t e = 0; e < 3 * mesh.triangleSlots(); ++e) {
    if (!mesh.alive(e / 3))
      continue;
    const std::int32_t other = mesh.twin(e);
    if (other != Triangulation::kNone) {
      ASSERT_EQ(mesh.twin(other), e);
      ASSERT_EQ(mesh.origin(other), mesh.destination(e));
    }
  }
  for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
    const std::int32_t e = mesh.leaving(std::int32_t(v));
    if (e != Triangulation::kNone) {
      ASSERT_EQ(mesh.origin(e), std::int32_t(v));
    }
  }
  ASSERT_EQ(checkTin(tinOf(mesh)), "");
}

/// No far corner of a neighbour inside a triangle's circle, in 128 bits by another formula.
bool isDelaunay(const Triangulation& mesh) {
  for (std::int32_t e = 0; e < 3 * mesh.triangleSlots(); ++e) {
    const std::int32_t other = mesh.twin(e);
    if (other == Triangulation::kNone)
      continue;
    const auto p = [&](std::int32_t v) { return mesh.vertex(v).corner; };
    const SpanCorner a = p(mesh.origin(e)), b = p(mesh.destination(e)),
                     c = p(mesh.origin(Triangulation::previous(e))),
                     d = p(mesh.origin(Triangulation::previous(other)));
    // The angles at c and d over the edge a-b sum to at most 180 degrees: sin(c + d) >= 0.
    const auto dotOf = [](const SpanCorner& o, const SpanCorner& x, const SpanCorner& y) {
      return Wide(x.u - o.u) * (y.u - o.u) + Wide(x.v - o.v) * (y.v - o.v);
    };
    const Wide sine =
        Wide(doubledArea(c, a, b)) * dotOf(d, b, a) + dotOf(c, a, b) * Wide(doubledArea(d, b, a));
    if (sine < 0)
      return false;
  }
  return true;
}

TEST(Triangulation, IsDelaunayForRandomPoints) {
  std::mt19937 random(3);
  Triangulation mesh;
  // Few distinct coordinates make many points on edges and on common circles.
  for (const int grain : {1, 100, 1000, 4000}) {
    startSquare(mesh);
    std::set<std::pair<int, int>> taken{
        {0, 0}, {0, kQuantizedMax}, {kQuantizedMax, 0}, {kQuantizedMax, kQuantizedMax}};
    for (int k = 0; k < 400; ++k) {
      const auto coordinate = [&] {
        return std::min(int(random() % 32768) / grain * grain, int(kQuantizedMax));
      };
      const int u = coordinate(), v = coordinate();
      if (taken.insert({u, v}).second)
        mesh.insert(at(u, v), std::int32_t(random() % std::uint32_t(mesh.triangleSlots())));
    }
    expectConsistent(mesh);
    EXPECT_TRUE(isDelaunay(mesh)) << grain;
    EXPECT_EQ(mesh.vertices().size(), taken.size());
  }
}

TEST(Triangulation, SplitsBorderEdges) {
  Triangulation mesh;
  startSquare(mesh);
  std::mt19937 random(8);
  std::set<int> taken{0, kQuantizedMax};
  for (int k = 0; k < 200; ++k) {
    const int p = int(random() % 32768);
    if (!taken.insert(p).second)
      continue;
    const NodeVertex places[] = {at(p, 0), at(0, p), at(p, kQuantizedMax), at(kQuantizedMax, p)};
    for (const NodeVertex& place : places)
      mesh.insert(place, 0);
  }
  expectConsistent(mesh);
  EXPECT_TRUE(isDelaunay(mesh));
}

TEST(Triangulation, ListsChangedTrianglesOnce) {
  Triangulation mesh;
  startSquare(mesh);
  EXPECT_EQ(mesh.changed().size(), 2u);
  for (const std::int32_t t : mesh.changed())
    mesh.clearChanged(t);
  mesh.changed().clear();
  mesh.insert(at(100, 30000), 0);
  const std::set<std::int32_t> once(mesh.changed().begin(), mesh.changed().end());
  EXPECT_EQ(once.size(), mesh.changed().size());
  for (const std::int32_t t : once)
    EXPECT_TRUE(mesh.isChanged(t));
}

TEST(Triangulation, CollapsesAndInsertsAgain) {
  std::mt19937 random(17);
  Triangulation mesh;
  startSquare(mesh);
  for (int k = 0; k < 300; ++k)
    mesh.insert(at(1 + int(random() % 32766), 1 + int(random() % 32766)), 0);
  std::vector<std::int32_t> star;
  int collapsed = 0;
  for (std::int32_t v = 4; v < 304; ++v) {
    mesh.star(v, star);
    for (const std::int32_t e : star) {
      const std::int32_t target = mesh.destination(e);
      bool positive = true;
      for (const std::int32_t s : star) {
        const std::int32_t a = mesh.destination(s);
        const std::int32_t b = mesh.origin(Triangulation::previous(s));
        positive = positive && (a == target || b == target ||
                                doubledArea(mesh.vertex(target).corner, mesh.vertex(a).corner,
                                            mesh.vertex(b).corner) > 0);
      }
      if (positive) {
        mesh.collapse(v, target);
        ++collapsed;
        break;
      }
    }
  }
  EXPECT_GT(collapsed, 250);
  expectConsistent(mesh);
  for (int k = 0; k < 300; ++k) {
    std::int32_t hint = 0;
    while (!mesh.alive(hint))
      ++hint;
    mesh.insert(at(1 + int(random() % 32766), 1 + int(random() % 32766)), hint);
  }
  expectConsistent(mesh);
}

} // namespace
} // namespace qmesh
