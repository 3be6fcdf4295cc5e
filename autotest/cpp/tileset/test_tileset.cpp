// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tileset/tileset.h"

#include <gtest/gtest.h>

#include <array>

#include "codec/encode.h"
#include "codec/gzip.h"
#include "tileset/tile_address.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

LayerJson layerOf(const std::string& pattern) {
  LayerJson layer;
  layer.tiles = {pattern};
  layer.version = "1.2.0";
  return layer;
}

std::string address(const std::string& path, const std::string& pattern, bool slippyMap = false) {
  LayerJson layer = layerOf(pattern);
  layer.slippyMap = slippyMap;
  return TileAddress(layerJsonPath(path), layer).of({3, 5, 2});
}

TEST(TileAddress, WhatAUserMayNameASet) {
  EXPECT_EQ(layerJsonPath("set"), "set/layer.json");
  EXPECT_EQ(layerJsonPath("/a/set/"), "/a/set/layer.json");
  EXPECT_EQ(layerJsonPath("/a/set/layer.json"), "/a/set/layer.json");
  EXPECT_EQ(layerJsonPath("QMESH:set"), "set/layer.json");
  EXPECT_EQ(layerJsonPath("qmesh:/a/layer.json"), "/a/layer.json");
  EXPECT_EQ(layerJsonPath("QMESH:https://h/t"), "/vsicurl/https://h/t/layer.json");
  EXPECT_EQ(layerJsonPath("http://h/t/layer.json?k=1"), "/vsicurl/http://h/t/layer.json?k=1");
  EXPECT_EQ(layerJsonPath("/vsizip/s.zip"), "/vsizip/s.zip/layer.json");
  EXPECT_EQ(layerJsonPath("/"), "/layer.json");
}

TEST(TileAddress, InAFolderTheQueryMeansNothing) {
  EXPECT_EQ(address("/s", "{z}/{x}/{y}.terrain?v={version}"), "/s/3/5/2.terrain");
  EXPECT_EQ(address("s/layer.json", "./t/{z}/{x}/{y}.terrain"), "s/t/3/5/2.terrain");
  EXPECT_EQ(address("layer.json", "{z}/{x}/{y}.terrain"), "./3/5/2.terrain");
  EXPECT_EQ(address("/s", "{z}/{x}/{y}.terrain", true), "/s/3/5/5.terrain");
  EXPECT_EQ(address("/s", "{z}/{x}/{reverseY}.terrain"), "/s/3/5/5.terrain");
  EXPECT_EQ(address("/s", "{z}/{x}/{reverseY}.terrain", true), "/s/3/5/2.terrain");
  EXPECT_EQ(address("/s", "{version}/{z}/{x}/{y}"), "/s/1.2.0/3/5/2");
  EXPECT_EQ(address("/s", "/tilesets/a/{z}/{x}/{y}.terrain"), "/s/3/5/2.terrain");
}

TEST(TileAddress, OnAServer) {
  const std::string set = "http://h:80/a/s/layer.json?key=7";
  EXPECT_EQ(address(set, "{z}/{x}/{y}.terrain?v={version}"),
            "/vsicurl/http://h:80/a/s/3/5/2.terrain?v=1.2.0&key=7");
  EXPECT_EQ(address(set, "{z}/{x}/{y}"), "/vsicurl/http://h:80/a/s/3/5/2?key=7");
  EXPECT_EQ(address("http://h/s", "/t/{z}/{x}/{y}"), "/vsicurl/http://h/t/3/5/2");
  EXPECT_EQ(address("http://h/s", "//i/t/{z}/{x}/{y}"), "/vsicurl/http://i/t/3/5/2");
  EXPECT_EQ(address("http://h/s", "https://i/{z}/{x}/{y}"), "/vsicurl/https://i/3/5/2");
  EXPECT_EQ(address("/s", "https://i/{z}/{x}/{y}?a={version}"), "/vsicurl/https://i/3/5/2?a=1.2.0");
}

/// A folder in GDAL's memory, removed with the test.
class TerrainSetTest : public ::testing::Test {
 protected:
  TerrainSetTest() : folder_("/vsimem/terrain_set") { removeTree(folder_); }
  ~TerrainSetTest() override { removeTree(folder_); }

  void write(const std::string& name, const std::string& text) {
    ASSERT_TRUE(writeWholeFile(folder_ + "/" + name, text.data(), text.size()).ok());
  }

  static std::vector<std::uint8_t> squareTile(const std::string& metadata = {}) {
    TileMesh mesh;
    mesh.header.maxHeight = 100;
    mesh.u = {0, 32767, 32767, 0};
    mesh.v = {0, 0, 32767, 32767};
    mesh.q = {0, 0, 32767, 32767};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.edges = {{{0, 3}, {0, 1}, {1, 2}, {2, 3}}};
    mesh.extensions.normals.assign(8, 0x80);
    mesh.extensions.metadata = metadata;
    return *encodeTile(mesh);
  }

  void writeTile(const std::string& name, const std::vector<std::uint8_t>& bytes) {
    ASSERT_TRUE(writeWholeFile(folder_ + "/" + name, bytes.data(), bytes.size()).ok());
  }

  static std::string layerText(const std::string& more) {
    return R"({"format":"quantized-mesh-1.0","tiles":["{z}/{x}/{y}.terrain?v={version}"],)" + more +
           "}";
  }

  std::string folder_;
};

TEST_F(TerrainSetTest, ReadsPlainAndCompressedTilesAndKnowsAMissingOne) {
  write("layer.json", layerText(R"("available":[[{"startX":0,"startY":0,"endX":1,"endY":0}]])"));
  writeTile("0/0/0.terrain", squareTile());
  writeTile("0/1/0.terrain", GzipCompressor().compress(squareTile()));
  for (const std::string& path :
       {folder_, folder_ + "/", folder_ + "/layer.json", "QMESH:" + folder_}) {
    const Result<Tileset> set = Tileset::open(path);
    ASSERT_TRUE(set.ok()) << set.status().message();
    for (const std::uint32_t x : {0u, 1u}) {
      const auto mesh = set->readTile({0, x, 0});
      ASSERT_TRUE(mesh.ok()) << mesh.status().message();
      ASSERT_TRUE(*mesh);
      EXPECT_EQ((*mesh)->vertexCount(), 4u);
    }
    EXPECT_EQ(set->maxZoom(), 0);
    EXPECT_TRUE(set->lists({0, 1, 0}));
    EXPECT_FALSE(set->mayHave({1, 1, 0}));
    const auto missing = set->readTile({1, 1, 0});
    ASSERT_TRUE(missing.ok()) << missing.status().message();
    EXPECT_FALSE(*missing);
  }
}

TEST_F(TerrainSetTest, FaultsNameTheFile) {
  EXPECT_EQ(Tileset::open(folder_).status().code(), Code::input);
  write("layer.json", "{}");
  EXPECT_NE(Tileset::open(folder_).status().message().find(folder_ + "/layer.json"),
            std::string::npos);
  write("layer.json", layerText(R"("available":[[{"startX":0,"startY":0,"endX":1,"endY":0}]])"));
  std::vector<std::uint8_t> tile = squareTile();
  tile.resize(100);
  writeTile("0/0/0.terrain", tile);
  const Result<Tileset> set = Tileset::open(folder_);
  ASSERT_TRUE(set.ok());
  const auto mesh = set->readTile({0, 0, 0});
  ASSERT_FALSE(mesh.ok());
  EXPECT_NE(mesh.status().message().find("0/0/0.terrain"), std::string::npos);
  tile = GzipCompressor().compress(squareTile());
  tile.resize(tile.size() - 9);
  writeTile("0/0/0.terrain", tile);
  EXPECT_FALSE(set->readTile({0, 0, 0}).ok());
}

TEST_F(TerrainSetTest, AFileThatCannotBeReadIsNoMissingOne) {
  write("layer.json", layerText(R"("available":[[{"startX":0,"startY":0,"endX":1,"endY":0}]])"));
  ASSERT_TRUE(makeFolders(folder_ + "/0/0/0.terrain").ok());
  const Result<Tileset> set = Tileset::open(folder_);
  ASSERT_TRUE(set.ok());
  EXPECT_FALSE(set->readTile({0, 0, 0}).ok());
}

TEST_F(TerrainSetTest, WithoutAListTheFolderTells) {
  write("layer.json", layerText(R"("scheme":"slippyMap")"));
  writeTile("0/0/0.terrain", squareTile());
  writeTile("2/5/3.terrain", squareTile());
  write("2/5/note.txt", "not a tile");
  write("2/05/1.terrain.tmp", "not a tile");
  write("9999999999/1/1.terrain", "no zoom");
  const Result<Tileset> set = Tileset::open(folder_);
  ASSERT_TRUE(set.ok()) << set.status().message();
  EXPECT_EQ(set->maxZoom(), 2);
  EXPECT_TRUE(set->lists({2, 5, 0}));
  EXPECT_EQ(set->available().count(2), 1u);
}

TEST_F(TerrainSetTest, WithoutAListTheRootsTell) {
  write("layer.json", layerText(R"("metadataAvailability":2,"maxzoom":7)"));
  const std::string below =
      R"({"available":[[{"startX":1,"startY":0,"endX":1,"endY":1}],[{"startX":2,"startY":0,"endX":3,"endY":3}]]})";
  writeTile("0/0/0.terrain", squareTile(below));
  const Result<Tileset> set = Tileset::open(folder_);
  ASSERT_TRUE(set.ok()) << set.status().message();
  EXPECT_TRUE(set->lists({0, 0, 0}));
  EXPECT_FALSE(set->lists({0, 1, 0}));
  EXPECT_EQ(set->available().count(1), 2u);
  EXPECT_EQ(set->available().count(2), 8u);
  EXPECT_TRUE(set->mayHave({3, 0, 0}));
  EXPECT_FALSE(set->mayHave({2, 0, 0}));
  EXPECT_FALSE(set->mayHave({8, 0, 0}));
  EXPECT_EQ(set->maxZoom(), 7);
}

TEST_F(TerrainSetTest, OldServersWroteLengthsTheOtherWayRound) {
  write("layer.json", layerText(R"("extensions":["vertexnormals"],"available":[[]])"));
  std::vector<std::uint8_t> tile = squareTile();
  const std::size_t length = tile.size() - 8 - 4; // of the normals, eight bytes
  ASSERT_EQ(tile[length], 8);
  std::swap(tile[length], tile[length + 3]);
  writeTile("0/0/0.terrain", tile);
  const Result<Tileset> set = Tileset::open(folder_);
  ASSERT_TRUE(set.ok()) << set.status().message();
  const auto mesh = set->readTile({0, 0, 0});
  ASSERT_TRUE(mesh.ok()) << mesh.status().message();
  EXPECT_EQ((*mesh)->extensions.normals.size(), 8u);
}

TEST_F(TerrainSetTest, OneTileAlone) {
  writeTile("3/5/2.terrain", squareTile());
  const std::string path = folder_ + "/3/5/2.terrain";
  Result<Tileset> set = Tileset::openTile(path);
  ASSERT_TRUE(set.ok()) << set.status().message();
  EXPECT_EQ(*set->singleTile(), (TileId{3, 5, 2}));
  EXPECT_TRUE(*set->readTile({3, 5, 2}));
  EXPECT_EQ(set->available().count(3), 1u);

  write("layer.json", layerText(R"("scheme":"slippyMap","available":[])"));
  set = Tileset::openTile(path);
  ASSERT_TRUE(set.ok());
  EXPECT_EQ(*set->singleTile(), (TileId{3, 5, 5}));
  EXPECT_TRUE(*set->readTile({3, 5, 5}));

  EXPECT_EQ(Tileset::openTile(folder_ + "/tile.terrain").status().code(), Code::input);
  EXPECT_EQ(Tileset::openTile(folder_ + "/3/99/2.terrain").status().code(), Code::input);
}

} // namespace
} // namespace qmesh
