// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/node_positions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace qmesh {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kLargestCell = 64;
constexpr int kSmallestCell = 8;
constexpr double kCellTolerance = 1.0 / 1024; ///< pixels

struct Point {
  double x = kNone;
  double y = kNone;

  bool exists() const { return x == x; }
};

Point mix(const Point& a, const Point& b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

class AffinePositions : public NodePositions {
 public:
  AffinePositions(const NodeLattice& lattice, const PixelFrame& frame)
      : lattice_(lattice), frame_(frame) {}

  PixelBounds fill(const NodeRectangle& window, double* x, double* y) override {
    PixelBounds bounds;
    for (int b = 0; b < window.height; ++b) {
      const double latitude = lattice_.latitude(window.j + b);
      double* rowX = x + std::ptrdiff_t(b) * window.width;
      double* rowY = y + std::ptrdiff_t(b) * window.width;
      if (b == 0 || frame_.rotated()) {
        for (int a = 0; a < window.width; ++a) {
          frame_.toPixel(lattice_.longitude(window.i + a), latitude, rowX[a], rowY[a]);
          bounds.add(rowX[a], rowY[a]);
        }
      } else { // the columns of the first row, one row number
        double unused = 0;
        double row = 0;
        frame_.toPixel(0, latitude, unused, row);
        std::copy(x, x + window.width, rowX);
        std::fill(rowY, rowY + window.width, row);
        bounds.add(rowX[0], row);
      }
    }
    return bounds;
  }

 private:
  NodeLattice lattice_;
  PixelFrame frame_;
};

/// The four corners of a control cell and the nodes it spans.
struct Cell {
  std::int64_t i = 0;
  std::int64_t j = 0;
  int size = 0;
  std::array<Point, 4> corner; ///< south-west, south-east, north-west, north-east

  Point at(double u, double v) const {
    return mix(mix(corner[0], corner[2], v), mix(corner[1], corner[3], v), u);
  }
};

class TransformedPositions : public NodePositions {
 public:
  TransformedPositions(const NodeLattice& lattice, const PixelFrame& frame,
                       PointTransform transform, const GeoBox& extent)
      : lattice_(lattice), frame_(frame), transform_(std::move(transform)), extent_(extent) {}

  PixelBounds fill(const NodeRectangle& window, double* x, double* y) override {
    window_ = window;
    x_ = x;
    y_ = y;
    bounds_ = {};
    const auto floorTo = [](std::int64_t n) { return n - n % kLargestCell; };
    for (std::int64_t j = floorTo(window.j); j < window.j + window.height; j += kLargestCell)
      for (std::int64_t i = floorTo(window.i); i < window.i + window.width; i += kLargestCell)
        fillCell(i, j, kLargestCell);
    dropOutside();
    return bounds_;
  }

 private:
  void fillCell(std::int64_t i, std::int64_t j, int size) {
    const std::int64_t i1 = std::min(i + size, window_.i + window_.width);
    const std::int64_t j1 = std::min(j + size, window_.j + window_.height);
    const std::int64_t i0 = std::max(i, window_.i);
    const std::int64_t j0 = std::max(j, window_.j);
    if (i0 >= i1 || j0 >= j1)
      return;
    Cell cell{i, j, size, {}};
    if (outside(i, j, size))
      return fillNone(i0, j0, i1, j1);
    if (interpolates(cell))
      return fillBilinear(cell, i0, j0, i1, j1);
    if (size == kSmallestCell)
      return fillExact(i0, j0, i1, j1);
    const int half = size / 2;
    for (int k = 0; k < 4; ++k)
      fillCell(i + k % 2 * half, j + k / 2 * half, half);
  }

  /// Exact position of a node; column columns() is +180 here, so that a cell stays in one piece.
  Point exact(std::int64_t i, std::int64_t j) const {
    double x = longitudeOf(i);
    double y = lattice_.latitude(j);
    const double longitude = x;
    if (!transform_.apply(x, y))
      return {};
    if (frame_.turn == 360) // datums move places a little, never by a turn
      x -= 360 * std::floor((x - longitude) / 360 + 0.5);
    Point out;
    frame_.toPixel(x, y, out.x, out.y);
    return out;
  }

  double longitudeOf(std::int64_t i) const {
    return lattice_.scheme().longitude(i, lattice_.columns());
  }

  /// Sets the corners; true where interpolation between them is as good as the exact transform.
  bool interpolates(Cell& cell) const {
    const int s = cell.size;
    const int h = s / 2;
    if (cell.i + s > lattice_.columns() || cell.j + s > lattice_.lastRow())
      return false;
    cell.corner = {exact(cell.i, cell.j), exact(cell.i + s, cell.j), exact(cell.i, cell.j + s),
                   exact(cell.i + s, cell.j + s)};
    for (const Point& corner : cell.corner)
      if (!corner.exists())
        return false;
    for (const auto& [a, b] : {std::pair{h, h}, {h, 0}, {0, h}, {s, h}, {h, s}}) {
      const Point want = exact(cell.i + a, cell.j + b);
      const Point got = cell.at(double(a) / s, double(b) / s);
      if (!(std::abs(want.x - got.x) <= kCellTolerance &&
            std::abs(want.y - got.y) <= kCellTolerance))
        return false;
    }
    return true;
  }

  std::size_t indexOf(std::int64_t i, std::int64_t j) const {
    return std::size_t(j - window_.j) * std::size_t(window_.width) + std::size_t(i - window_.i);
  }

  void fillBilinear(const Cell& cell, std::int64_t i0, std::int64_t j0, std::int64_t i1,
                    std::int64_t j1) {
    const double step = 1.0 / cell.size;
    const int count = int(i1 - i0);
    const int first = int(i0 - cell.i);
    for (std::int64_t j = j0; j < j1; ++j) {
      const double v = double(j - cell.j) * step;
      const Point left = mix(cell.corner[0], cell.corner[2], v);
      const Point right = mix(cell.corner[1], cell.corner[3], v);
      const double dx = right.x - left.x;
      const double dy = right.y - left.y;
      double* x = x_ + indexOf(i0, j);
      double* y = y_ + indexOf(i0, j);
      for (int a = 0; a < count; ++a) {
        const double u = (first + a) * step;
        x[a] = left.x + dx * u;
        y[a] = left.y + dy * u;
      }
      if (j == j0 || j == j1 - 1) { // a bilinear function is extreme at the corners of a rectangle
        bounds_.add(x[0], y[0]);
        bounds_.add(x[count - 1], y[count - 1]);
      }
    }
  }

  void fillExact(std::int64_t i0, std::int64_t j0, std::int64_t i1, std::int64_t j1) {
    for (std::int64_t j = j0; j < j1; ++j)
      for (std::int64_t i = i0; i < i1; ++i) {
        const Point p = exact(i, j);
        x_[indexOf(i, j)] = p.x;
        y_[indexOf(i, j)] = p.y;
        if (p.exists())
          bounds_.add(p.x, p.y);
        else
          bounds_.complete = false;
      }
  }

  void fillNone(std::int64_t i0, std::int64_t j0, std::int64_t i1, std::int64_t j1) {
    bounds_.complete = false;
    for (std::int64_t j = j0; j < j1; ++j)
      std::fill(x_ + indexOf(i0, j), x_ + indexOf(i0, j) + (i1 - i0), kNone);
  }

  /// True where the extent does not meet the cell.
  bool outside(std::int64_t i, std::int64_t j, int size) const {
    return !meetsLongitudes(longitudeOf(i), longitudeOf(i + size)) ||
           lattice_.latitude(j) > extent_.north ||
           lattice_.latitude(std::min(j + size, lattice_.lastRow())) < extent_.south;
  }

  bool meetsLongitudes(double west, double east) const {
    return (west <= extent_.east && east >= extent_.west) ||
           (west + 360 <= extent_.east && east + 360 >= extent_.west);
  }

  /// Takes the position of nodes outside the extent away.
  void dropOutside() {
    std::vector<int> away; // columns
    for (int a = 0; a < window_.width; ++a) {
      const double longitude = longitudeOf(window_.i + a);
      if (!meetsLongitudes(longitude, longitude))
        away.push_back(a);
    }
    for (int b = 0; b < window_.height; ++b) {
      double* row = x_ + std::ptrdiff_t(b) * window_.width;
      const double latitude = lattice_.latitude(window_.j + b);
      const bool none = latitude > extent_.north || latitude < extent_.south;
      if (none)
        std::fill(row, row + window_.width, kNone);
      else
        for (int a : away)
          row[a] = kNone;
      if (none || !away.empty())
        bounds_.complete = false;
    }
  }

  NodeLattice lattice_;
  PixelFrame frame_;
  PointTransform transform_;
  GeoBox extent_;
  // What fill() works on.
  NodeRectangle window_;
  double* x_ = nullptr;
  double* y_ = nullptr;
  PixelBounds bounds_;
};

} // namespace

void PixelBounds::add(double x, double y) {
  west = std::min(west, x);
  east = std::max(east, x);
  north = std::min(north, y);
  south = std::max(south, y);
}

std::unique_ptr<NodePositions> makeAffinePositions(const NodeLattice& lattice,
                                                   const PixelFrame& frame) {
  return std::make_unique<AffinePositions>(lattice, frame);
}

Result<std::unique_ptr<NodePositions>> makeTransformedPositions(const NodeLattice& lattice,
                                                                const PixelFrame& frame,
                                                                const OGRSpatialReference& srs,
                                                                const GeoBox& extent,
                                                                const std::string& path) {
  Result<PointTransform> transform = PointTransform::create(lonLatSrs(), srs, path);
  if (!transform.ok())
    return transform.status();
  return std::unique_ptr<NodePositions>(
      std::make_unique<TransformedPositions>(lattice, frame, *std::move(transform), extent));
}

} // namespace qmesh
