// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "export/mesh_writers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "base/text.h"
#include "geo/ellipsoid.h"
#include "square.h"

namespace qmesh {
namespace {

std::size_t countOf(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

std::string lineOf(const std::string& text, std::size_t number) {
  return std::string(split(text, '\n')[number]);
}

TEST(MeshWriters, OffIsTheMeshInDegrees) {
  const std::string text = offText(square(), MeshFrame::lonlat);
  EXPECT_EQ(lineOf(text, 0), "OFF");
  EXPECT_EQ(lineOf(text, 2), "4 2 0");
  EXPECT_EQ(lineOf(text, 3), "10 0 0");
  EXPECT_EQ(lineOf(text, 5), "11 1 1000");
  EXPECT_EQ(lineOf(text, 7), "3 0 1 2");
  EXPECT_EQ(lineOf(text, 8), "3 0 2 3");
  EXPECT_EQ(text.back(), '\n');
}

TEST(MeshWriters, LocalMetresAreEastNorthUpFromTheMiddle) {
  const std::string text = objText(square(), MeshFrame::local);
  std::istringstream first(lineOf(text, 1));
  std::string letter;
  double east = 0, north = 0, up = 0;
  first >> letter >> east >> north >> up;
  EXPECT_EQ(letter, "v");
  EXPECT_NEAR(east, -0.5 * 111319.49, 5);
  EXPECT_NEAR(north, -0.5 * 110574, 5);
  EXPECT_NEAR(up, -(55659.0 * 55659 + 55287.0 * 55287) / (2 * 6367000), 5); // the globe's curve
  EXPECT_EQ(countOf(text, "\nf "), 2u);
  EXPECT_NE(text.find("\nf 1 2 3\nf 1 3 4\n"), std::string::npos);
}

TEST(MeshWriters, EarthFixedIsOnTheEllipsoid) {
  const std::string text = offText(square(), MeshFrame::ecef);
  std::istringstream high(lineOf(text, 5));
  Vec3 p;
  high >> p.x >> p.y >> p.z;
  EXPECT_NEAR(length(p - wgs84::toEcef(11, 1, 1000)), 0, 1e-4 * 2);
}

TEST(MeshWriters, NormalsAreTurnedIntoTheFrame) {
  ExportMesh mesh = square();
  for (const ExportVertex& vertex : mesh.vertices)
    mesh.normals.push_back(
        wgs84::normal(10 + vertex.u / 32767, vertex.v / 32767)); // straight up everywhere
  EXPECT_EQ(countOf(objText(mesh, MeshFrame::lonlat), "\nvn 0 0 1"), 4u);
  EXPECT_NE(objText(mesh, MeshFrame::lonlat).find("\nf 1//1 2//2 3//3\n"), std::string::npos);
  const std::string ply = plyText(mesh, MeshFrame::lonlat);
  EXPECT_NE(ply.find("\n10 0 0 0 0 1\n"), std::string::npos);
  EXPECT_EQ(countOf(objText(mesh, MeshFrame::local), "\nvn 0 0 1"), 0u); // at the corners it leans
}

TEST(MeshWriters, PlySaysItsCounts) {
  const std::string text = plyText(square(), MeshFrame::local);
  EXPECT_EQ(lineOf(text, 0), "ply");
  EXPECT_NE(text.find("element vertex 4\n"), std::string::npos);
  EXPECT_NE(text.find("element face 2\n"), std::string::npos);
  EXPECT_EQ(text.find("property float nx"), std::string::npos);
  EXPECT_EQ(split(text.substr(text.find("end_header\n") + 11), '\n').size(), 4u + 2 + 1);
}

TEST(MeshWriters, SvgHasOnePathATriangleAndTheBorder) {
  MeshDrawing drawing;
  drawing.width = 100;
  const std::string text = svgText(square(), drawing);
  EXPECT_EQ(countOf(text, "Z\" fill"), 2u);
  EXPECT_NE(text.find("<title>a &lt;square&gt;</title>"), std::string::npos);
  EXPECT_NE(text.find("width=\"100\" height=\"99\""), std::string::npos);
  const std::string border = text.substr(text.find("class=\"border\""));
  EXPECT_EQ(countOf(border, "M"), 4u); // the four sides, not the diagonal
  EXPECT_NE(text.find("M0 99L100 99 100 0Z"), std::string::npos);
}

TEST(MeshWriters, ANameWithLineEndsStaysInItsComment) {
  ExportMesh mesh = square();
  mesh.name = "one\ntwo";
  EXPECT_EQ(lineOf(objText(mesh, MeshFrame::local), 0).substr(0, 9), "# one two");
}

} // namespace
} // namespace qmesh
