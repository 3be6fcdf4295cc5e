// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "mesh/check.h"

#include <gtest/gtest.h>

#include "mesh/tile_frame.h"

namespace qmesh {
namespace {

constexpr std::uint16_t kMax = kQuantizedMax;

//  3 ---- 2
//  | \  / |
//  |  4   |
//  | /  \ |
//  0 ---- 1
Tin valid() {
  Tin tin;
  tin.vertices = {{0, 0, 5}, {kMax, 0, 0}, {kMax, kMax, kMax}, {0, kMax, 7}, {9000, 20000, 3}};
  tin.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return tin;
}

TEST(CheckTin, PassesAValidMesh) {
  EXPECT_EQ(checkTin(valid()), "");
}

TEST(CheckTin, FindsAnIndexOutOfRange) {
  Tin tin = valid();
  tin.triangles[1][2] = 5;
  EXPECT_NE(checkTin(tin).find("names vertex 5"), std::string::npos);
}

TEST(CheckTin, FindsAnUnusedVertex) {
  Tin tin = valid();
  tin.vertices.push_back({1, 2, 3});
  EXPECT_NE(checkTin(tin).find("in no triangle"), std::string::npos);
}

TEST(CheckTin, FindsTwoVerticesAtOnePlace) {
  Tin tin = valid();
  tin.vertices.push_back(tin.vertices[4]);
  tin.triangles[2][2] = 5;
  EXPECT_NE(checkTin(tin).find("two vertices"), std::string::npos);
}

TEST(CheckTin, FindsAVertexBeyondTheSquare) {
  Tin tin = valid();
  tin.vertices[4].q = 32768;
  EXPECT_NE(checkTin(tin).find("beyond 32767"), std::string::npos);
}

TEST(CheckTin, FindsAClockwiseTriangle) {
  Tin tin = valid();
  std::swap(tin.triangles[3][0], tin.triangles[3][1]);
  EXPECT_NE(checkTin(tin).find("triangle 3 is clockwise"), std::string::npos);
}

TEST(CheckTin, FindsAFoldOver) {
  Tin tin = valid();
  tin.vertices.push_back({100, 30000, 0});
  tin.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 5}, {3, 0, 4}, {2, 5, 4}, {5, 3, 4}};
  EXPECT_NE(checkTin(tin).find("clockwise"), std::string::npos);
}

TEST(CheckTin, FindsATriangleWithoutArea) {
  Tin tin = valid();
  tin.vertices[4] = {0, 20000, 3};
  EXPECT_NE(checkTin(tin).find("triangle 3 has no area"), std::string::npos);
}

TEST(CheckTin, FindsAHole) {
  Tin tin = valid();
  tin.triangles.pop_back();
  EXPECT_NE(checkTin(tin).find("areas sum"), std::string::npos);
}

TEST(CheckTin, FindsATriangleTwice) {
  Tin tin = valid();
  tin.triangles.push_back(tin.triangles[0]);
  EXPECT_NE(checkTin(tin), "");
}

TEST(CheckTin, FindsEdgesUsedTwiceTheSameWay) {
  // One triangle missing, another of the same area twice: the sum of areas is right.
  Tin tin = valid();
  tin.vertices[4] = {16383, 16383, 3};
  tin.triangles[2] = tin.triangles[3];
  EXPECT_NE(checkTin(tin), "");
}

TEST(CheckTin, FindsATJunction) {
  //  3 --------- 2      4 lies on the diagonal of the triangle 0 2 3
  //  |        /  |
  //  |    4      |
  //  | /         |
  //  0 --------- 1
  Tin tin = valid();
  tin.vertices[4] = {10000, 10000, 3};
  tin.triangles = {{0, 1, 4}, {1, 2, 4}, {0, 2, 3}};
  EXPECT_NE(checkTin(tin).find("has one triangle"), std::string::npos);
}

TEST(CheckTin, FindsAnEmptyMesh) {
  EXPECT_NE(checkTin(Tin{}), "");
}

TEST(CheckTin, Finds65536Vertices) {
  Tin tin = valid();
  tin.vertices.resize(65536);
  EXPECT_NE(checkTin(tin).find("65536"), std::string::npos);
}

} // namespace
} // namespace qmesh
