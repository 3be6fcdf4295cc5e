// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "codec/encode.h"
#include "codec/gzip.h"
#include "random_mesh.h"
#include "validate/mesh_checks.h"
#include "validate/seam_checks.h"
#include "validate/tile_bytes.h"

namespace qmesh {
namespace {

using test::randomMesh;

std::set<int> codesOf(const Findings& findings) {
  std::set<int> codes;
  for (const Finding& finding : findings)
    codes.insert(finding.code);
  return codes;
}

/// A proper mesh, in order of first use, with exact edge lists.
TileMesh properMesh(std::mt19937& random, std::size_t side = 9) {
  TileMesh mesh = randomMesh(random, side, side, 20);
  orderForEncoding(mesh);
  return mesh;
}

std::set<int> meshCodes(const TileMesh& mesh) {
  Findings findings;
  checkMesh(mesh, {{12, 0, 0}, {0, 0, 0.01, 0.01}, 20, "12/0/0"}, findings);
  return codesOf(findings);
}

std::set<int> byteCodes(const std::vector<std::uint8_t>& bytes) {
  Findings findings;
  readTileBytes(bytes, ExtensionLengths::littleEndian, "t", findings);
  return codesOf(findings);
}

TEST(TileChecks, ProperMeshesPass) {
  std::mt19937 random(1);
  for (std::size_t side : {2, 3, 9, 40}) {
    const TileMesh mesh = properMesh(random, side);
    EXPECT_EQ(meshCodes(mesh), std::set<int>()) << side;
    const auto bytes = encodeTile(mesh);
    ASSERT_TRUE(bytes.ok());
    EXPECT_EQ(byteCodes(*bytes), std::set<int>()) << side;
    EXPECT_EQ(byteCodes(GzipCompressor().compress(*bytes)), std::set<int>()) << side;
  }
}

TEST(TileChecks, EveryShorterFileIsAFindingAndNoCrash) {
  std::mt19937 random(2);
  const auto bytes = encodeTile(properMesh(random, 4));
  ASSERT_TRUE(bytes.ok());
  for (std::size_t size = 0; size < bytes->size(); ++size) {
    const std::vector<std::uint8_t> cut(bytes->begin(), bytes->begin() + std::ptrdiff_t(size));
    Findings findings;
    const ReadTile tile = readTileBytes(cut, ExtensionLengths::littleEndian, "t", findings);
    // Between two extensions a shorter file is a whole one.
    EXPECT_TRUE(!findings.empty() || tile.mesh) << size;
  }
}

TEST(TileChecks, BytesTurnedOverNeverCrash) {
  std::mt19937 random(3);
  const auto bytes = encodeTile(properMesh(random, 6));
  ASSERT_TRUE(bytes.ok());
  for (int k = 0; k < 4000; ++k) {
    std::vector<std::uint8_t> wrong = *bytes;
    for (int n = 0; n <= k % 3; ++n)
      wrong[random() % wrong.size()] = std::uint8_t(random());
    Findings findings;
    const ReadTile tile = readTileBytes(wrong, ExtensionLengths::littleEndian, "t", findings);
    if (!tile.mesh)
      continue;
    const TileContext context{{3, 0, 0}, {0, 0, 10, 10}, 9000, "3/0/0"};
    checkMesh(*tile.mesh, context, findings);
    checkHeader(*tile.mesh, earthFixed(*tile.mesh, context.box), context, findings);
    tileEdges(*tile.mesh);
  }
}

TEST(TileChecks, EachFaultOfAMeshIsToldAlone) {
  std::mt19937 random(4);
  const TileMesh good = properMesh(random);
  TileMesh mesh = good;
  std::swap(mesh.indices[30], mesh.indices[31]);
  EXPECT_EQ(meshCodes(mesh), std::set<int>{302});
  mesh = good;
  mesh.indices.insert(mesh.indices.end(), {mesh.indices[0], mesh.indices[1], mesh.indices[1]});
  EXPECT_EQ(meshCodes(mesh), std::set<int>{301});
  mesh = good;
  mesh.indices.insert(mesh.indices.end(), good.indices.begin(), good.indices.begin() + 3);
  EXPECT_EQ(meshCodes(mesh), std::set<int>{305});
  mesh = good;
  mesh.edges[2].pop_back();
  EXPECT_EQ(meshCodes(mesh), std::set<int>{208});
  mesh = good;
  std::swap(mesh.edges[0], mesh.edges[2]);
  EXPECT_EQ(meshCodes(mesh), std::set<int>{209});
}

/// A fan of many triangles at one vertex: the search for pairs must not be quadratic, nor wrong.
TEST(TileChecks, FansAreSearchedRight) {
  TileMesh mesh;
  const int spokes = 3000;
  const auto add = [&](int u, int v) {
    mesh.u.push_back(std::uint16_t(u));
    mesh.v.push_back(std::uint16_t(v));
    mesh.q.push_back(0);
  };
  add(0, 0);
  for (int k = 0; k <= spokes; ++k) // up the east side, then to the north-west corner
    add(32767, 32767 * k / spokes);
  add(0, 32767);
  for (std::uint32_t k = 1; k + 1 < mesh.u.size(); ++k)
    mesh.indices.insert(mesh.indices.end(), {0, k, k + 1});
  for (std::uint32_t k = 0; k < mesh.u.size(); ++k) {
    if (mesh.u[k] == 0)
      mesh.edges[0].push_back(k);
    if (mesh.v[k] == 0)
      mesh.edges[1].push_back(k);
    if (mesh.u[k] == 32767)
      mesh.edges[2].push_back(k);
    if (mesh.v[k] == 32767)
      mesh.edges[3].push_back(k);
  }
  EXPECT_EQ(meshCodes(mesh), std::set<int>());
  mesh.indices.erase(mesh.indices.begin() + 300, mesh.indices.begin() + 303);
  EXPECT_EQ(meshCodes(mesh), std::set<int>{307});
}

TileEdge edgeOf(std::vector<std::uint16_t> at, std::vector<double> heights, double step) {
  TileEdge edge;
  edge.at = std::move(at);
  edge.heights = std::move(heights);
  edge.step = step;
  return edge;
}

std::set<int> seamCodes(const TileEdge& a, const TileEdge& b, double* gap = nullptr) {
  Findings findings;
  SeamReport report;
  checkSeam(a, b, "seam", report, findings);
  if (gap)
    *gap = report.largestGap;
  return codesOf(findings);
}

TEST(Seams, GapsAreMeasuredAlongTheWholeEdge) {
  const TileEdge straight = edgeOf({0, 32767}, {0, 32767}, 0.01);
  EXPECT_EQ(seamCodes(straight, straight), std::set<int>());
  double gap = 0;
  const TileEdge bent = edgeOf({0, 16000, 32767}, {0, 16010, 32767}, 0.01);
  EXPECT_EQ(seamCodes(straight, bent, &gap), (std::set<int>{501, 503}));
  EXPECT_NEAR(gap, 10, 1e-9);
  EXPECT_EQ(seamCodes(bent, straight, &gap), (std::set<int>{501, 503}));
  EXPECT_NEAR(gap, 10, 1e-9);
  const TileEdge split = edgeOf({0, 16000, 32767}, {0, 16000, 32767}, 0.01);
  EXPECT_EQ(seamCodes(straight, split), std::set<int>{501}); // other vertices, the same surface
}

TEST(Seams, RoundingIsToldFromCracks) {
  const TileEdge edge = edgeOf({0, 32767}, {5, 6}, 0.1);
  EXPECT_EQ(seamCodes(edge, edgeOf({0, 32767}, {5.0009, 6}, 0.1)), std::set<int>());
  EXPECT_EQ(seamCodes(edge, edgeOf({0, 32767}, {5.15, 6}, 0.1)), std::set<int>{502});
  EXPECT_EQ(seamCodes(edge, edgeOf({0, 32767}, {5.25, 6}, 0.1)), std::set<int>{503});
}

TEST(Seams, NormalsAreCompared) {
  TileEdge a = edgeOf({0, 32767}, {0, 0}, 0.1), b = a;
  a.normals = {{1, 2}, {3, 4}};
  EXPECT_EQ(seamCodes(a, b), std::set<int>()); // only one side has them: told of the tile
  b.normals = {{1, 2}, {3, 5}};
  EXPECT_EQ(seamCodes(a, b), std::set<int>{504});
}

TEST(Seams, APoleHasOneHeight) {
  const TileEdge flat = edgeOf({0, 32767}, {7, 7}, 0.1), other = edgeOf({0, 32767}, {7, 8}, 0.1);
  Findings findings;
  checkPole({&flat, &flat}, "north pole", findings);
  EXPECT_TRUE(findings.empty());
  checkPole({&flat, &other}, "north pole", findings);
  EXPECT_EQ(codesOf(findings), std::set<int>{505});
}

} // namespace
} // namespace qmesh
