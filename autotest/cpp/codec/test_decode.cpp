// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/decode.h"

#include <gtest/gtest.h>

#include <memory>

#include "codec/encode.h"
#include "golden_tile.h"
#include "random_mesh.h"

namespace qmesh {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Decodes a copy of exactly the right size, so that a sanitizer sees every read beyond.
Result<TileMesh> decode(const Bytes& bytes) {
  const auto copy = std::make_unique<std::uint8_t[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), copy.get());
  return decodeTile(copy.get(), bytes.size());
}

void expectFault(const Bytes& bytes, const std::string& words) {
  const auto mesh = decode(bytes);
  ASSERT_FALSE(mesh.ok()) << words;
  EXPECT_EQ(mesh.status().code(), Code::input);
  EXPECT_NE(mesh.status().message().find(words), std::string::npos) << mesh.status().message();
}

// Where the parts of the golden tile begin.
constexpr std::size_t kVertexCount = 88, kU = 92, kTriangleCount = 116, kIndices = 120, kWest = 132,
                      kExtensions = 164;

Bytes changed(std::size_t at, Bytes to) {
  Bytes bytes = test::goldenBytes();
  std::copy(to.begin(), to.end(), bytes.begin() + std::ptrdiff_t(at));
  return bytes;
}

Bytes extended(Bytes extension) {
  Bytes bytes = test::goldenBytes();
  bytes.insert(bytes.end(), extension.begin(), extension.end());
  return bytes;
}

TEST(Decode, ReadsTheGoldenTile) {
  const auto mesh = decode(test::goldenBytes());
  ASSERT_TRUE(mesh.ok()) << mesh.status().message();
  EXPECT_TRUE(test::sameMesh(*mesh, test::goldenMesh()));
  EXPECT_EQ(mesh->edges, test::goldenMesh().edges);
}

TEST(Decode, RefusesEveryShorterTile) {
  const Bytes whole = test::goldenBytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto mesh = decode(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size)));
    // Only between extensions can a tile end early.
    const bool complete =
        size == kExtensions || size == kExtensions + 13 || size == kExtensions + 19;
    EXPECT_EQ(mesh.ok(), complete) << size;
  }
}

TEST(Decode, RefusesEveryShorterTileWithWideIndices) {
  std::mt19937 random(51);
  TileMesh wide = test::randomMesh(random, 256, 256, 1);
  wide.extensions.normals.clear();
  wide.extensions.waterMask.clear();
  wide.extensions.metadata.clear();
  orderForEncoding(wide);
  const Bytes whole = *encodeTile(wide);
  for (std::size_t size = 3; size < whole.size(); size += 99991)
    EXPECT_FALSE(decode(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))).ok()) << size;
  const std::size_t lastEdge = whole.size() - 4 * wide.edges[3].size() - 4;
  for (std::size_t size = lastEdge - 30; size < whole.size(); size += 13)
    EXPECT_FALSE(decode(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))).ok()) << size;
}

TEST(Decode, NoChangeOfAByteMakesAnInvalidMesh) {
  const Bytes whole = test::goldenBytes();
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (int value = 0; value < 256; ++value) {
      const auto mesh = decode(changed(at, {std::uint8_t(value)}));
      if (mesh.ok()) {
        EXPECT_EQ(test::invalidity(*mesh), "") << at << " = " << value;
      } else {
        EXPECT_EQ(mesh.status().code(), Code::input);
      }
    }
}

TEST(Decode, NoChangeOfSeveralBytesMakesAnInvalidMesh) {
  std::mt19937 random(52);
  for (int k = 0; k < 50000; ++k) {
    Bytes bytes = test::goldenBytes();
    for (int i = 0; i < 3; ++i)
      bytes[kVertexCount + random() % (bytes.size() - kVertexCount)] = std::uint8_t(random());
    const auto mesh = decode(bytes);
    if (mesh.ok()) {
      EXPECT_EQ(test::invalidity(*mesh), "");
    }
  }
}

TEST(Decode, SaysWhatIsWrong) {
  expectFault({}, "header");
  expectFault(changed(kVertexCount, {0xff, 0xff, 0xff, 0xff}), "vertices");
  expectFault(changed(kVertexCount, {0, 0, 0, 0}), "no vertices");
  expectFault(changed(kU, {1, 0}), "outside 0..32767");          // -1
  expectFault(changed(kU, {0, 0, 0xfe, 0xff, 2, 0}), "outside"); // 32768
  expectFault(changed(kTriangleCount, {0xff, 0xff, 0xff, 0xff}), "triangles");
  expectFault(changed(kTriangleCount, {0, 0, 0, 0}), "no triangles");
  expectFault(changed(kIndices, {1, 0}), "a triangle names"); // back before the first vertex
  expectFault(changed(kIndices + 6, {0, 0, 0, 0}), "a triangle names"); // a fifth vertex
  expectFault(changed(kWest, {0xff, 0xff, 0xff, 0x7f}), "edge list");
  expectFault(changed(kWest + 4, {4, 0}), "edge list names");
  expectFault(changed(kExtensions + 1, {16}), "normals");
  expectFault(changed(kExtensions + 1, {0xff, 0xff, 0xff, 0xff}), "inside extension 1");
  expectFault(changed(kExtensions + 14, {2}), "water mask");
  expectFault(changed(kExtensions + 24, {3}), "metadata");
  expectFault(changed(24, {0, 0, 0xc0, 0x7f}), "least or greatest height"); // NaN
  expectFault(extended({9}), "head of an extension");
}

TEST(Decode, PassesOverUnknownExtensions) {
  const auto mesh = decode(extended({77, 3, 0, 0, 0, 1, 2, 3, 200, 0, 0, 0, 0}));
  ASSERT_TRUE(mesh.ok()) << mesh.status().message();
  EXPECT_TRUE(test::sameMesh(*mesh, test::goldenMesh()));
}

TEST(Decode, KeepsARestOfTheHeaderThatIsNotANumber) {
  const auto mesh = decode(changed(64 + 6, {0xf8, 0x7f}));
  ASSERT_TRUE(mesh.ok());
  EXPECT_TRUE(std::isnan(mesh->header.horizon.x));
}

// The specification gives a tile of 65536 vertices 16-bit indices.
TEST(Decode, ReadsNarrowIndicesOf65536Vertices) {
  Bytes bytes = test::goldenBytes();
  bytes.resize(kVertexCount);
  bytes.insert(bytes.end(), {0, 0, 1, 0});
  bytes.resize(bytes.size() + 6 * 65536, 0);
  bytes.insert(bytes.end(), {1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  bytes.insert(bytes.end(), {1, 0, 0, 0, 0xff, 0xff});
  bytes.resize(bytes.size() + 12, 0);
  const auto mesh = decode(bytes);
  ASSERT_TRUE(mesh.ok()) << mesh.status().message();
  EXPECT_EQ(mesh->edges[0], std::vector<std::uint32_t>{65535});
}

} // namespace
} // namespace qmesh
