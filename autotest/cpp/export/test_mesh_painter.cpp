// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "export/mesh_painter.h"

#include <gtest/gtest.h>

#include <array>

#include "square.h"

namespace qmesh {
namespace {

std::array<int, 3> pixel(RgbImage& image, int column, int row) {
  const std::uint8_t* p = image.at(column, row);
  return {p[0], p[1], p[2]};
}

MeshDrawing plain(MeshShade shade, bool lines) {
  MeshDrawing drawing;
  drawing.width = 100;
  drawing.shade = shade;
  drawing.lines = lines;
  return drawing;
}

TEST(MeshPainter, BorderIsRedAndTheInsideFilled) {
  RgbImage image = paintMesh(square(), plain(MeshShade::none, false));
  EXPECT_EQ(image.width, 100);
  EXPECT_EQ(image.height, 99);
  ASSERT_EQ(image.pixels.size(), 3u * 100 * 99);
  for (int k = 0; k < 99; ++k) {
    EXPECT_EQ(pixel(image, k, 0)[0], 200) << k;
    EXPECT_EQ(pixel(image, 99, k)[1], 30) << k;
  }
  EXPECT_EQ(pixel(image, 50, 50), (std::array<int, 3>{255, 255, 255}));
}

TEST(MeshPainter, LinesAreDrawnOnRequest) {
  RgbImage image = paintMesh(square(), plain(MeshShade::none, true));
  int dark = 0;
  for (int row = 10; row < 90; ++row)
    for (int column = 10; column < 90; ++column)
      dark += pixel(image, column, row)[0] < 250;
  EXPECT_GT(dark, 79);  // the diagonal
  EXPECT_LT(dark, 320); // and nothing else
}

TEST(MeshPainter, ColourFollowsTheHeight) {
  ExportMesh mesh = square();
  mesh.vertices = {{0, 0, 0}, {32767, 0, 0}, {32767, 32767, 0}, {0, 32767, 500}};
  RgbImage image = paintMesh(mesh, plain(MeshShade::height, false));
  EXPECT_NE(pixel(image, 80, 80), pixel(image, 20, 20)); // south-east low, north-west high
  EXPECT_GT(pixel(image, 80, 80)[1], pixel(image, 80, 80)[0]) << "low ground is green";
}

TEST(MeshPainter, SlopesAreDark) {
  ExportMesh mesh = square();
  mesh.vertices = {{0, 0, 0}, {32767, 0, 0}, {32767, 32767, 0}, {0, 32767, 200000}};
  RgbImage image = paintMesh(mesh, plain(MeshShade::slope, false));
  EXPECT_EQ(pixel(image, 80, 80)[0], 255); // flat
  EXPECT_LT(pixel(image, 20, 20)[0], 150); // 60 degrees
}

TEST(MeshPainter, AnEmptyMeshIsAWhiteSheet) {
  ExportMesh mesh;
  mesh.box = {0, 0, 1, 1};
  const RgbImage image = paintMesh(mesh, plain(MeshShade::height, true));
  for (const std::uint8_t value : image.pixels)
    ASSERT_EQ(value, 255);
}

} // namespace
} // namespace qmesh
