// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cassert>
#include <cmath>

#include "mesh/base_grid.h"
#include "simplify/decimator.h"
#include "simplify/exact_refinement.h"
#include "simplify/methods.h"
#include "simplify/metric_scale.h"
#include "simplify/node_heights.h"
#include "simplify/node_mesh.h"
#include "simplify/refinement_rounds.h"

namespace qmesh {

namespace {

/// Cells per edge of the densest grid of seeds.
constexpr int kSeedCells = 8;

/// Garland & Heckbert, "Fast polygonal approximation of terrains and height fields" (1995), with
/// RefinementRounds in the place of the heap.
class Greedy final : public Simplifier {
 public:
  explicit Greedy(const MethodOptions& options) : options_(options) {}

  bool choosesBorder() const override { return true; }

  Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                  const LevelParams& level, Tin& out) override;

 private:
  Result<int> askedGrid(const LevelParams& level, int cells) const;
  void start(const Border& border, int grid);
  void refine(float tolerance);
  void seed(double tolerance);
  void insertNode(int i, int j, std::int32_t hint);
  void maskBorder(const Border& border);
  ErrorMeasure avoidForbiddenVertexCount(Tin& out);
  void report(const ErrorMeasure& measure, const LevelParams& level, Tin& out) const;

  MethodOptions options_;
  const HeightTile* tile_ = nullptr;
  const TileFrame* frame_ = nullptr;
  NodeMesh nodes_;
  Triangulation& mesh_ = nodes_.triangulation();
  NodeHeights heights_;
  ErrorDistance distance_;
  Decimator decimator_;
  RefinementRounds rounds_;
  ExactRefinement exact_;
};

Status Greedy::simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                        const LevelParams& level, Tin& out) {
  assert(tile.cells() == frame.cells());
  tile_ = &tile;
  frame_ = &frame;
  const Result<int> asked = askedGrid(level, tile.cells());
  if (!asked.ok())
    return asked.status();
  BaseGrid grid(frame, level);
  grid.addNodes(*asked);
  const bool across = options_.errorType == ErrorType::distance3d;
  distance_ = across ? ErrorDistance(metricScale(tile)) : ErrorDistance();
  exact_.reset(tile, frame, level.maxError);
  exact_.setDistance(distance_);
  exact_.setFreeEdges(border.isFree);
  heights_.reset(tile, frame);
  start(border, *asked);
  mesh_.limitFlips(grid);
  const float tolerance = heights_.scanTolerance(level.maxError);
  seed(tolerance);
  refine(tolerance);
  if (options_.decimate) {
    decimator_.run(mesh_, heights_, grid, tolerance, distance_);
    mesh_.forgetChanges();
  }
  ErrorMeasure measure = exact_.run(nodes_, out);
  if (out.vertices.size() == kForbiddenVertexCount)
    measure = avoidForbiddenVertexCount(out);
  report(measure, level, out);
  return {};
}

/// Cells per edge of the grid whose nodes stay: the base grid or a finer one that was asked
/// for.
Result<int> Greedy::askedGrid(const LevelParams& level, int cells) const {
  const auto asked = options_.initGrid.find(level.zoom);
  if (!asked.ok())
    return asked.status();
  int grid = level.baseGrid;
  while (grid < cells && grid < asked->value_or(0))
    grid *= 2;
  return grid;
}

/// Rounds of inserting the worst nodes until all are within the tolerance.
void Greedy::refine(float tolerance) {
  rounds_.run(
      mesh_,
      [&](std::int32_t t) {
        const SpanCorner &a = mesh_.cornerOf(t, 0).corner, &b = mesh_.cornerOf(t, 1).corner,
                         &c = mesh_.cornerOf(t, 2).corner;
        const double perDistance = distance_.heightPerDistance(a, b, c);
        NodeError worst = heights_.worst(a, b, c, float(tolerance * perDistance));
        worst.error = float(worst.error / perDistance);
        return worst;
      },
      [&](const Candidate& candidate) {
        if (heights_.isMasked(candidate.node))
          return false;
        insertNode(heights_.column(candidate.node), heights_.row(candidate.node),
                   candidate.triangle);
        return true;
      });
}

/// A first coarse mesh without scans: of ever denser grids, the nodes that are off by more than the
/// tolerance when their turn comes. It saves the rounds in which few triangles hold all nodes.
void Greedy::seed(double tolerance) {
  const int n = frame_->cells();
  for (int step = n / 4; step >= std::max(n / kSeedCells, 4); step /= 2) {
    for (int j = step; j < n; j += step) {
      for (int i = step; i < n; i += step) {
        if (heights_.isMasked(heights_.index(i, j)))
          continue;
        const NodeVertex vertex = nodes_.makeVertex(i, j);
        const std::int32_t t = mesh_.locate(vertex.corner, mesh_.changed().back());
        const SpanCorner &a = mesh_.cornerOf(t, 0).corner, &b = mesh_.cornerOf(t, 1).corner,
                         &c = mesh_.cornerOf(t, 2).corner;
        const double error = std::abs(planeHeight(a, b, c, vertex.corner) - vertex.corner.height);
        if (error > tolerance * distance_.heightPerDistance(a, b, c))
          insertNode(i, j, t);
      }
    }
  }
}

/// The corners, the border and the grid.
void Greedy::start(const Border& border, int grid) {
  const int n = frame_->cells();
  nodes_.reset(*tile_, *frame_, border, grid);
  maskBorder(border);
  const int step = n / grid;
  for (int j = step; j < n; j += step) {
    for (int i = step; i < n; i += step)
      heights_.mask(i, j);
  }
}

void Greedy::insertNode(int i, int j, std::int32_t hint) {
  nodes_.insert(i, j, hint);
  heights_.mask(i, j);
}

/// The border's vertices are given; its other nodes have no say but on free edges.
void Greedy::maskBorder(const Border& border) {
  const int n = frame_->cells();
  for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
    const bool alongRow = edge == kSouth || edge == kNorth;
    const int across = edge == kEast || edge == kNorth ? n : 0;
    const auto mask = [&](int k) {
      alongRow ? heights_.mask(k, across) : heights_.mask(across, k);
    };
    for (const std::uint16_t place : border[edge])
      mask(alongRow ? frame_->nearestColumn(place) : frame_->nearestRow(place));
    for (int k = 0; k <= n && !border.isFree[std::size_t(edge)]; ++k)
      mask(k);
  }
}

/// A mesh of 65536 vertices gets one more, the worst node of all, or has to do with one less.
ErrorMeasure Greedy::avoidForbiddenVertexCount(Tin& out) {
  if (exact_.insertWorst(nodes_))
    return exact_.run(nodes_, out);
  decimator_.removeAny(mesh_, heights_);
  nodes_.write(out);
  return measureError(*tile_, *frame_, out);
}

void Greedy::report(const ErrorMeasure& measure, const LevelParams& level, Tin& out) const {
  const auto across = std::size_t(frame_->cells()) + 1;
  out.maxError = measure.max;
  out.sumSquaredError = measure.sumSquared;
  if (measure.max > level.maxError) // across the planes it may be all right
    out.reason = distance_.isHeight() ? StopReason::quantization : StopReason::parameter;
  else
    out.reason =
        out.vertices.size() == across * across ? StopReason::allNodes : StopReason::maxError;
}

} // namespace

std::unique_ptr<Simplifier> createGreedy(const MethodOptions& options) {
  return std::make_unique<Greedy>(options);
}

} // namespace qmesh
