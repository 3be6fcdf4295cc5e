// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "codec/encode.h"
#include "codec/gzip.h"
#include "golden_tile.h"
#include "random_mesh.h"

namespace qmesh {
namespace {

using test::randomMesh;

/// A vertex by what it is, not by its number.
using Vertex = std::array<int, 5>;

Vertex vertexOf(const TileMesh& mesh, std::uint32_t i) {
  return {mesh.u[i], mesh.v[i], mesh.q[i], mesh.extensions.normals[2 * i],
          mesh.extensions.normals[2 * i + 1]};
}

/// How often each triangle occurs, begun at its least corner, which keeps the orientation.
std::map<std::array<Vertex, 3>, int> trianglesOf(const TileMesh& mesh) {
  std::map<std::array<Vertex, 3>, int> triangles;
  for (std::size_t h = 0; h < mesh.indices.size(); h += 3) {
    std::array<Vertex, 3> t{vertexOf(mesh, mesh.indices[h]), vertexOf(mesh, mesh.indices[h + 1]),
                            vertexOf(mesh, mesh.indices[h + 2])};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    ++triangles[t];
  }
  return triangles;
}

std::vector<Vertex> edgeOf(const TileMesh& mesh, std::size_t edge) {
  std::vector<Vertex> vertices;
  for (const std::uint32_t i : mesh.edges[edge])
    vertices.push_back(vertexOf(mesh, i));
  return vertices;
}

TEST(Order, KeepsEveryTriangleAndItsOrientation) {
  std::mt19937 random(41);
  for (int k = 0; k < 200; ++k) {
    const TileMesh before = randomMesh(random, 2 + random() % 9, 2 + random() % 9, random() % 2);
    TileMesh after = before;
    orderForEncoding(after);
    EXPECT_EQ(trianglesOf(after), trianglesOf(before));
  }
}

TEST(Order, NumbersVerticesByFirstUse) {
  std::mt19937 random(42);
  TileMesh mesh = randomMesh(random, 20, 30);
  orderForEncoding(mesh);
  std::uint32_t next = 0;
  for (const std::uint32_t index : mesh.indices) {
    ASSERT_LE(index, next);
    next += index == next;
  }
  EXPECT_EQ(next, mesh.vertexCount());
}

TEST(Order, SortsEdgesAsClientsWantThem) {
  std::mt19937 random(43);
  const TileMesh before = randomMesh(random, 12, 9);
  TileMesh after = before;
  orderForEncoding(after);
  for (std::size_t e = 0; e < 4; ++e) {
    auto expected = edgeOf(before, e);
    const std::size_t along = e % 2 == 0 ? 1 : 0; // v on the west and east edge, u on the others
    const int sign = e == 0 || e == 3 ? 1 : -1;
    std::sort(expected.begin(), expected.end(),
              [&](const Vertex& a, const Vertex& b) { return sign * a[along] < sign * b[along]; });
    EXPECT_EQ(edgeOf(after, e), expected);
  }
}

TEST(Order, DoesNotDependOnTheNumbering) {
  std::mt19937 random(44);
  for (int k = 0; k < 100; ++k) {
    TileMesh mesh = randomMesh(random, 2 + random() % 15, 2 + random() % 15, random() % 2);
    TileMesh other = test::renumbered(mesh, random);
    orderForEncoding(mesh);
    orderForEncoding(other);
    EXPECT_EQ(*encodeTile(mesh), *encodeTile(other));
  }
}

TEST(Order, OfAnOrderedMeshChangesNothing) {
  TileMesh mesh = test::goldenMesh();
  orderForEncoding(mesh);
  TileMesh again = mesh;
  orderForEncoding(again);
  EXPECT_TRUE(test::sameMesh(again, mesh));
  EXPECT_EQ(mesh.edges[3].size(), 2u);
}

TEST(Order, ReachesPartsThatDoNotHangTogether) {
  TileMesh mesh;
  mesh.u = {0, 10, 0, 20, 30, 30};
  mesh.v = {0, 0, 10, 20, 20, 30};
  mesh.q = {1, 2, 3, 4, 5, 6};
  mesh.indices = {3, 4, 5, 2, 0, 1};
  orderForEncoding(mesh);
  EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(mesh.q, (std::vector<std::uint16_t>{1, 2, 3, 4, 5, 6}));
}

TEST(Order, OfNothingIsNothing) {
  TileMesh mesh;
  orderForEncoding(mesh);
  EXPECT_TRUE(mesh.indices.empty());
}

/// A smooth hill on a regular grid: what terrain looks like to the compressor.
TileMesh hill(std::mt19937& random) {
  TileMesh mesh = randomMesh(random, 33, 33);
  mesh.extensions.normals.clear();
  mesh.extensions.waterMask.clear();
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    const double x = mesh.u[i] / 32767.0, y = mesh.v[i] / 32767.0;
    mesh.q[i] = std::uint16_t(32767 * x * (1 - x) * (y + 1));
  }
  return mesh;
}

TEST(Order, HalvesTheCompressedSize) {
  std::mt19937 random(45);
  TileMesh mesh = hill(random);
  TileMesh plain = mesh; // triangles as they come, vertices by first use
  std::vector<std::uint32_t> number(mesh.vertexCount(), ~0u);
  std::uint32_t next = 0;
  for (std::uint32_t& index : plain.indices) {
    if (number[index] == ~0u) {
      number[index] = next;
      plain.u[next] = mesh.u[index];
      plain.v[next] = mesh.v[index];
      plain.q[next++] = mesh.q[index];
    }
    index = number[index];
  }
  orderForEncoding(mesh);
  GzipCompressor gzip;
  EXPECT_LT(2 * gzip.compress(*encodeTile(mesh)).size(), gzip.compress(*encodeTile(plain)).size());
}

} // namespace
} // namespace qmesh
