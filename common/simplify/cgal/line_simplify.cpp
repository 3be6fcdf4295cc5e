// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/cgal/line_simplify.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyline_simplification_2/Vertex_base_2.h>
#include <CGAL/Polyline_simplification_2/simplify.h>

namespace qmesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using VertexBase = CGAL::Polyline_simplification_2::Vertex_base_2<Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Lines = CGAL::Constrained_triangulation_plus_2<Delaunay>;

/// Costs are told apart to this grain, metres.
constexpr double kCostGrain = 1.0 / 4096;
/// Costs beyond this count as this, metres.
constexpr double kLargestCost = 1 << 19;
/// More than any node's number, a power of two.
constexpr double kNodeNumbers = 1 << 21;

/// What it costs to take a node out: the largest height error of the new piece at all the nodes
/// that were ever taken out between its two ends. Each cost has the node's number
/// in digits below the grain: no two are equal, so CGAL's queue, whose order of equals depends on
/// addresses, has one order (promise P3).
class HeightCost {
 public:
  HeightCost(const HeightTile& tile, const TileFrame& frame, const BaseGrid& curvature)
      : tile_(tile), frame_(frame), curvature_(curvature) {}

  boost::optional<double> operator()(const Lines&,
                                     Lines::Vertices_in_constraint_iterator at) const {
    const auto before = boost::prior(at), after = boost::next(at);
    const Point from = (*before)->point(), to = (*after)->point();
    if (from == to || !isShort(from, to)) // the first: what is left of a closed line
      return boost::none;
    const Piece piece{from, to, height(from), height(to) - height(from)};
    double worst = 0;
    Lines::Points_in_constraint_iterator point(before), end(after);
    for (++point; point != end; ++point)
      worst = std::max(worst, errorAt(*point, piece));
    return std::floor(std::min(worst, kLargestCost) / kCostGrain) * kCostGrain +
           number((*at)->point()) * (kCostGrain / kNodeNumbers);
  }

 private:
  struct Piece {
    Point from, to;
    double height, rise; ///< metres, at `from` and from there to the other end
  };

  /// The error at a node that a piece passes by: its height against the piece's at the nearest
  /// place, and what the surface rises on the way there where it is steepest. So a line leaves the
  /// foot of a cliff no more than its top, though the ground there is level.
  double errorAt(const Point& point, const Piece& piece) const {
    const double du = piece.to.x() - piece.from.x(), dv = piece.to.y() - piece.from.y();
    const double pu = point.x() - piece.from.x(), pv = point.y() - piece.from.y();
    const double along = std::clamp((pu * du + pv * dv) / (du * du + dv * dv), 0.0, 1.0);
    const double error = std::abs(height(point) - piece.height - along * piece.rise);
    const int i = column(point), j = row(point);
    const int south = std::min(j, tile_.cells() - 1);
    const double columns = std::abs(along * du - pu) * tile_.cells() / kQuantizedMax;
    const double rows = std::abs(along * dv - pv) / (frame_.nodeV(south + 1) - frame_.nodeV(south));
    return error + columns * steepest(i, j, 1, 0) + rows * steepest(i, j, 0, 1);
  }

  /// Metres to the higher or lower of the two neighbours in one direction.
  double steepest(int i, int j, int di, int dj) const {
    const int n = tile_.cells();
    const double h = tile_.at(i, j);
    const double up = tile_.at(std::min(i + di, n), std::min(j + dj, n)) - h;
    const double down = tile_.at(std::max(i - di, 0), std::max(j - dj, 0)) - h;
    return std::max(std::abs(up), std::abs(down));
  }

  bool isShort(const Point& from, const Point& to) const {
    const auto u = std::int64_t(to.x() - from.x()), v = std::int64_t(to.y() - from.y());
    return curvature_.isShort(u * u + v * v);
  }

  int column(const Point& point) const { return frame_.nearestColumn(std::uint16_t(point.x())); }
  int row(const Point& point) const { return frame_.nearestRow(std::uint16_t(point.y())); }
  double height(const Point& point) const { return tile_.at(column(point), row(point)); }
  double number(const Point& point) const {
    return NodeGrid(frame_.cells()).index(column(point), row(point));
  }

  const HeightTile& tile_;
  const TileFrame& frame_;
  const BaseGrid& curvature_;
};

/// Stops before the first cost above the max error.
class StopAbove {
 public:
  explicit StopAbove(double maxError) : limit_(maxError + kCostGrain) {}

  bool operator()(const Lines&, Lines::Vertex_handle, double cost, std::size_t, std::size_t) const {
    return cost >= limit_;
  }

 private:
  double limit_;
};

} // namespace

void simplifyLines(const HeightTile& tile, const TileFrame& frame, const BaseGrid& curvature,
                   double maxError, std::vector<NodeLine>& lines) {
  const NodeGrid grid(frame.cells());
  Lines all;
  std::vector<Lines::Constraint_id> ids;
  std::vector<Point> points;
  for (const NodeLine& line : lines) {
    points.clear();
    for (const NodeIndex node : line)
      points.emplace_back(frame.u(grid.column(node)), frame.v(grid.row(node)));
    ids.push_back(all.insert_constraint(points.begin(), points.end()));
  }
  CGAL::Polyline_simplification_2::simplify(all, HeightCost(tile, frame, curvature),
                                            StopAbove(maxError), false);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    lines[k].clear();
    for (auto at = all.vertices_in_constraint_begin(ids[k]);
         at != all.vertices_in_constraint_end(ids[k]); ++at) {
      const Point& point = (*at)->point();
      lines[k].push_back(grid.index(frame.nearestColumn(std::uint16_t(point.x())),
                                    frame.nearestRow(std::uint16_t(point.y()))));
    }
  }
}

} // namespace qmesh
