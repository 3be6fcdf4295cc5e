// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "export/mesh_painter.h"

#include <algorithm>
#include <cmath>

#include "export/mesh_places.h"
#include "export/shading.h"

namespace qmesh {

namespace {

using Point = Plan::Point;

constexpr int kFine = 3;                               ///< sub-pixels an edge of a pixel
constexpr double kLineWidth = 0.6, kBorderWidth = 2.5; ///< pixels

double turn(const Point& a, const Point& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// Calls `paint` for each pixel of the image whose middle lies in the box.
template <class Paint>
void eachPixel(const RgbImage& image, const Point& low, const Point& high, Paint paint) {
  const int left = std::max(0, int(std::floor(low.x)));
  const int top = std::max(0, int(std::floor(low.y)));
  const int right = std::min(image.width - 1, int(std::floor(high.x)));
  const int bottom = std::min(image.height - 1, int(std::floor(high.y)));
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column)
      paint(column, row, column + 0.5, row + 0.5);
}

void put(RgbImage& image, int column, int row, const Rgb& colour) {
  std::copy(colour.begin(), colour.end(), image.at(column, row));
}

void fillTriangle(RgbImage& image, const std::array<Point, 3>& p, const Rgb& colour) {
  const Point low = {std::min({p[0].x, p[1].x, p[2].x}), std::min({p[0].y, p[1].y, p[2].y})};
  const Point high = {std::max({p[0].x, p[1].x, p[2].x}), std::max({p[0].y, p[1].y, p[2].y})};
  const double side = turn(p[0], p[1], p[2].x, p[2].y) < 0 ? -1 : 1;
  eachPixel(image, low, high, [&](int column, int row, double x, double y) {
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k)
      inside = inside && side * turn(p[k], p[(k + 1) % 3], x, y) >= 0;
    if (inside)
      put(image, column, row, colour);
  });
}

void drawLine(RgbImage& image, const Point& a, const Point& b, double width, const Rgb& colour) {
  const double reach = width / 2;
  const Point low = {std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach};
  const Point high = {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach};
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  eachPixel(image, low, high, [&](int column, int row, double x, double y) {
    const double along =
        squared > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / squared, 0.0, 1.0) : 0;
    const double ex = x - (a.x + along * dx), ey = y - (a.y + along * dy);
    if (ex * ex + ey * ey <= reach * reach)
      put(image, column, row, colour);
  });
}

RgbImage reduced(RgbImage& fine) {
  RgbImage image{fine.width / kFine, fine.height / kFine, {}};
  image.pixels.resize(3 * std::size_t(image.width) * std::size_t(image.height));
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (int k = 0; k < kFine * kFine; ++k)
          sum += fine.at(column * kFine + k % kFine, row * kFine + k / kFine)[channel];
        image.at(column, row)[channel] =
            std::uint8_t((2 * sum + kFine * kFine) / (2 * kFine * kFine));
      }
  return image;
}

} // namespace

RgbImage paintMesh(const ExportMesh& mesh, const MeshDrawing& drawing) {
  Plan plan = planOf(mesh, drawing.width);
  for (Point& point : plan.points)
    point = {point.x * kFine, point.y * kFine};
  RgbImage fine{plan.width * kFine, plan.height * kFine, {}};
  fine.pixels.assign(3 * std::size_t(fine.width) * std::size_t(fine.height), 255);
  const std::vector<Rgb> colours = triangleColours(mesh, drawing.shade);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    fillTriangle(fine,
                 {plan.points[triangle[0]], plan.points[triangle[1]], plan.points[triangle[2]]},
                 colours[t]);
  }
  for (const Plan::Edge& edge : plan.inner)
    if (drawing.lines)
      drawLine(fine, plan.points[edge[0]], plan.points[edge[1]], kLineWidth * kFine, kLineColour);
  for (const Plan::Edge& edge : plan.border)
    drawLine(fine, plan.points[edge[0]], plan.points[edge[1]], 2 * kBorderWidth * kFine,
             kBorderColour);
  return reduced(fine);
}

} // namespace qmesh
