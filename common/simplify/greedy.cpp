// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cassert>
#include <cmath>

#include "simplify/decimator.h"
#include "simplify/exact_refinement.h"
#include "simplify/methods.h"
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

  Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                  const LevelParams& level, Tin& out) override;

 private:
  void start(const Border& border, int baseGrid);
  void seed(double tolerance);
  void insertNode(int i, int j, std::int32_t hint);
  void maskBorder();
  ErrorMeasure leaveForbiddenCount(Tin& out);
  void report(const ErrorMeasure& measure, const LevelParams& level, Tin& out) const;

  MethodOptions options_;
  const HeightTile* tile_ = nullptr;
  const TileFrame* frame_ = nullptr;
  NodeMesh nodes_;
  Triangulation& mesh_ = nodes_.triangulation();
  NodeHeights heights_;
  Decimator decimator_;
  RefinementRounds rounds_;
  ExactRefinement exact_;
};

Status Greedy::simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                        const LevelParams& level, Tin& out) {
  assert(tile.cells() == frame.cells());
  tile_ = &tile;
  frame_ = &frame;
  exact_.reset(tile, frame, level.maxError);
  heights_.reset(tile, frame);
  start(border, level.baseGrid);
  const float tolerance = heights_.scanTolerance(level.maxError);
  seed(tolerance);
  rounds_.run(
      mesh_,
      [&](std::int32_t t) {
        return heights_.worst(mesh_.cornerOf(t, 0).corner, mesh_.cornerOf(t, 1).corner,
                              mesh_.cornerOf(t, 2).corner, tolerance);
      },
      [&](const Candidate& candidate) {
        if (heights_.isMasked(candidate.node))
          return false;
        insertNode(heights_.column(candidate.node), heights_.row(candidate.node),
                   candidate.triangle);
        return true;
      });
  if (options_.decimate) {
    decimator_.run(mesh_, heights_, tile.cells() / level.baseGrid, tolerance);
    mesh_.forgetChanges();
  }
  ErrorMeasure measure = exact_.run(nodes_, out);
  if (out.vertices.size() == kForbiddenVertexCount)
    measure = leaveForbiddenCount(out);
  report(measure, level, out);
  return {};
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
        const double height = planeHeight(mesh_.cornerOf(t, 0).corner, mesh_.cornerOf(t, 1).corner,
                                          mesh_.cornerOf(t, 2).corner, vertex.corner);
        if (std::abs(height - vertex.corner.height) > tolerance)
          insertNode(i, j, t);
      }
    }
  }
}

/// The corners, the border and the curvature grid.
void Greedy::start(const Border& border, int baseGrid) {
  const int n = frame_->cells();
  nodes_.reset(*tile_, *frame_, border, baseGrid);
  maskBorder();
  const int baseCells = n / baseGrid;
  for (int j = baseCells; j < n; j += baseCells) {
    for (int i = baseCells; i < n; i += baseCells)
      heights_.mask(i, j);
  }
}

void Greedy::insertNode(int i, int j, std::int32_t hint) {
  nodes_.insert(i, j, hint);
  heights_.mask(i, j);
}

/// The border's vertices are given; its other nodes have no say.
void Greedy::maskBorder() {
  const int n = frame_->cells();
  for (int k = 0; k <= n; ++k) {
    heights_.mask(k, 0);
    heights_.mask(k, n);
    heights_.mask(0, k);
    heights_.mask(n, k);
  }
}

/// A mesh of 65536 vertices gets one more, the worst node of all, or has to do with one less.
ErrorMeasure Greedy::leaveForbiddenCount(Tin& out) {
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
  if (measure.max > level.maxError)
    out.reason = StopReason::quantization;
  else
    out.reason =
        out.vertices.size() == across * across ? StopReason::allNodes : StopReason::maxError;
}

} // namespace

std::unique_ptr<Simplifier> createGreedy(const MethodOptions& options) {
  return std::make_unique<Greedy>(options);
}

} // namespace qmesh
