// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/error_measure.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/check.h"
#include "terrain.h"

namespace qmesh {
namespace {

using namespace test;

/// A random valid TIN: random points (not only nodes) put one by one into the triangle that holds
/// them, so with thin triangles among them.
Tin randomTin(int points, std::mt19937& random) {
  constexpr std::uint16_t max = kQuantizedMax;
  Tin tin;
  const auto q = [&] { return std::uint16_t(random() % 32768); };
  tin.vertices = {{0, 0, q()}, {max, 0, q()}, {max, max, q()}, {0, max, q()}};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (int k = 0; k < points; ++k) {
    const TinVertex p{std::uint16_t(1 + random() % 32766), std::uint16_t(1 + random() % 32766),
                      q()};
    for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
      const TinTriangle corners = tin.triangles[t];
      bool inside = true;
      for (std::size_t e = 0; e < 3; ++e) {
        const TinVertex& a = tin.vertices[corners[e]];
        const TinVertex& b = tin.vertices[corners[(e + 1) % 3]];
        inside = inside &&
                 std::int64_t(b.u - a.u) * (p.v - a.v) - std::int64_t(b.v - a.v) * (p.u - a.u) > 0;
      }
      if (!inside)
        continue;
      const auto index = std::uint32_t(tin.vertices.size());
      tin.vertices.push_back(p);
      tin.triangles[t] = {corners[0], corners[1], index};
      tin.triangles.push_back({corners[1], corners[2], index});
      tin.triangles.push_back({corners[2], corners[0], index});
      break;
    }
  }
  return tin;
}

/// Every node against every triangle, in long double; a node on an edge takes the first.
ErrorMeasure bruteForce(const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
  ErrorMeasure measure;
  for (int j = 0; j <= frame.cells(); ++j) {
    for (int i = 0; i <= frame.cells(); ++i) {
      const long double u = frame.nodeU(i), v = frame.nodeV(j);
      for (const TinTriangle& t : tin.triangles) {
        const TinVertex &a = tin.vertices[t[0]], &b = tin.vertices[t[1]], &c = tin.vertices[t[2]];
        const auto area = [](long double au, long double av, long double bu, long double bv,
                             long double cu, long double cv) {
          return (bu - au) * (cv - av) - (bv - av) * (cu - au);
        };
        const long double whole = area(a.u, a.v, b.u, b.v, c.u, c.v);
        const long double wa = area(u, v, b.u, b.v, c.u, c.v) / whole;
        const long double wb = area(a.u, a.v, u, v, c.u, c.v) / whole;
        const long double wc = area(a.u, a.v, b.u, b.v, u, v) / whole;
        if (wa < -1e-15L || wb < -1e-15L || wc < -1e-15L)
          continue;
        const long double height =
            wa * frame.decode(a.q) + wb * frame.decode(b.q) + wc * frame.decode(c.q);
        const double error = std::abs(double(height - tile.at(i, j)));
        measure.sumSquared += error * error;
        measure.max = std::max(measure.max, error);
        break;
      }
    }
  }
  return measure;
}

TEST(MeasureError, AgreesWithBruteForce) {
  std::mt19937 random(20260101);
  for (const Place& place : places()) {
    if (place.cells > 64)
      continue;
    for (const int points : {0, 3, 40, 400}) {
      SCOPED_TRACE(testing::Message() << place << " points " << points);
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, random());
      TileFrame frame;
      frame.reset(patch.tile(), place.level(5));
      const Tin tin = randomTin(points, random);
      ASSERT_EQ(checkTin(tin), "");
      const ErrorMeasure expected = bruteForce(patch.tile(), frame, tin);
      const ErrorMeasure found = measureError(patch.tile(), frame, tin);
      EXPECT_NEAR(found.max, expected.max, 1e-7);
      EXPECT_NEAR(found.sumSquared, expected.sumSquared, 1e-9 * expected.sumSquared);
    }
  }
}

// With a height of 1 above the plane at every node the sum of squares counts the nodes.
TEST(MeasureError, CountsEveryNodeOnceWithVerticesOnNodes) {
  const int n = 16;
  const Place place{Profile::geodetic, 8, 100, 100, n};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i)
      patch.at(i, j) = 1;
  }
  TileFrame frame;
  frame.reset(patch.tile(), place.level(5));
  ASSERT_EQ(frame.minHeight(), 1);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i)
      patch.at(i, j) = 2;
  }
  for (const int stride : {1, 2, 4, 16}) {
    Tin tin;
    const int across = n / stride;
    for (int j = 0; j <= across; ++j) {
      for (int i = 0; i <= across; ++i)
        tin.vertices.push_back({frame.u(i * stride), frame.v(j * stride), 0});
    }
    for (int j = 0; j < across; ++j) {
      for (int i = 0; i < across; ++i) {
        const auto sw = std::uint32_t(j * (across + 1) + i), nw = sw + std::uint32_t(across) + 1;
        tin.triangles.push_back({sw, sw + 1, nw + 1});
        tin.triangles.push_back({sw, nw + 1, nw});
      }
    }
    ASSERT_EQ(checkTin(tin), "");
    const ErrorMeasure measure = measureError(patch.tile(), frame, tin);
    EXPECT_EQ(measure.max, 1);
    EXPECT_EQ(measure.sumSquared, (n + 1) * (n + 1)) << stride;
  }
}

TEST(MeasureError, CountsEveryNodeOnceInRandomMeshes) {
  std::mt19937 random(99);
  for (const Place& place : places()) {
    TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
    const int n = place.cells;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i)
        patch.at(i, j) = 1;
    }
    TileFrame frame;
    frame.reset(patch.tile(), place.level(5));
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i)
        patch.at(i, j) = 2;
    }
    Tin tin = randomTin(300, random);
    for (TinVertex& vertex : tin.vertices)
      vertex.q = 0;
    EXPECT_EQ(measureError(patch.tile(), frame, tin).sumSquared, (n + 1) * (n + 1)) << place;
  }
}

} // namespace
} // namespace qmesh
