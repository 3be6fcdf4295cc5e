// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/encode.h"

#include <gtest/gtest.h>

#include <functional>

#include "codec/decode.h"
#include "golden_tile.h"
#include "random_mesh.h"

namespace qmesh {
namespace {

using test::goldenMesh;
using test::randomMesh;

TEST(Encode, WritesTheGoldenTile) {
  const auto bytes = encodeTile(goldenMesh());
  ASSERT_TRUE(bytes.ok()) << bytes.status().message();
  EXPECT_EQ(*bytes, test::goldenBytes());
}

TEST(Encode, LeavesOutExtensionsThatAreEmpty) {
  TileMesh mesh = goldenMesh();
  mesh.extensions.normals.clear();
  mesh.extensions.waterMask.clear();
  mesh.extensions.metadata.clear();
  auto expected = test::goldenBytes();
  expected.resize(expected.size() - 30);
  EXPECT_EQ(*encodeTile(mesh), expected);
}

void expectRoundTrip(TileMesh mesh) {
  orderForEncoding(mesh);
  const auto bytes = encodeTile(mesh);
  ASSERT_TRUE(bytes.ok()) << bytes.status().message();
  const auto back = decodeTile(bytes->data(), bytes->size());
  ASSERT_TRUE(back.ok()) << back.status().message();
  EXPECT_TRUE(test::sameMesh(*back, mesh));
  EXPECT_EQ(back->edges, mesh.edges);
}

TEST(Encode, DecodingGivesTheMeshBack) {
  std::mt19937 random(31);
  for (int k = 0; k < 300; ++k)
    expectRoundTrip(randomMesh(random, 2 + random() % 12, 2 + random() % 12, random() % 2));
}

TEST(Encode, IndicesWidenAt65536Vertices) {
  std::mt19937 random(32);
  const TileMesh narrow = randomMesh(random, 255, 257);
  ASSERT_EQ(narrow.vertexCount(), 65535u);
  expectRoundTrip(narrow);
  for (const std::size_t extra : {1u, 2u}) { // an odd and an even count: with and without padding
    const TileMesh wide = randomMesh(random, 256, 256, extra);
    ASSERT_EQ(wide.vertexCount(), 65536 + extra);
    expectRoundTrip(wide);
  }
}

TEST(Encode, Refuses65536Vertices) {
  std::mt19937 random(33);
  TileMesh mesh = randomMesh(random, 256, 256);
  orderForEncoding(mesh);
  const auto bytes = encodeTile(mesh);
  ASSERT_FALSE(bytes.ok());
  EXPECT_NE(bytes.status().message().find("65536"), std::string::npos);
}

struct Fault {
  const char* name;
  std::function<void(TileMesh&)> make;
};

TEST(Encode, RefusesMeshesThatAreNotOne) {
  const std::vector<Fault> faults = {
      {"order of first use", [](TileMesh& m) { std::swap(m.indices[0], m.indices[1]); }},
      {"vertex not used", [](TileMesh& m) { m.indices.resize(3); }},
      {"index too large",
       [](TileMesh& m) {
         m.indices.insert(m.indices.end(), {0, 3, 4});
       }},
      {"part of a triangle", [](TileMesh& m) { m.indices.push_back(0); }},
      {"no triangle", [](TileMesh& m) { m.indices.clear(); }},
      {"u longer", [](TileMesh& m) { m.u.push_back(1); }},
      {"v shorter", [](TileMesh& m) { m.v.pop_back(); }},
      {"q longer", [](TileMesh& m) { m.q.push_back(1); }},
      {"u above 32767", [](TileMesh& m) { m.u[2] = 32768; }},
      {"q above 32767", [](TileMesh& m) { m.q[3] = 65535; }},
      {"edge index too large", [](TileMesh& m) { m.edges[2][0] = 4; }},
      {"a normal missing", [](TileMesh& m) { m.extensions.normals.pop_back(); }},
      {"water mask of 2 bytes", [](TileMesh& m) { m.extensions.waterMask.push_back(0); }},
  };
  for (const Fault& fault : faults) {
    TileMesh mesh = goldenMesh();
    fault.make(mesh);
    const auto bytes = encodeTile(mesh);
    ASSERT_FALSE(bytes.ok()) << fault.name;
    EXPECT_EQ(bytes.status().code(), Code::internal) << fault.name;
  }
}

} // namespace
} // namespace qmesh
