// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "mesh/error_measure.h"
#include "simplify/decimator.h"
#include "simplify/methods.h"
#include "simplify/node_heights.h"
#include "simplify/node_mesh.h"

namespace qmesh {

namespace {

/// Cells per edge of the densest grid of seeds.
constexpr int kSeedCells = 8;

/// Relative difference of two ways to compute one error.
constexpr double kRoundingSlack = 1e-9;

/// The bits of a node with a vertex at each of its four places.
constexpr std::uint8_t kAllPlaces = 15;

/// A node to insert and the triangle it is the worst of.
struct Candidate {
  std::uint64_t order; ///< largest error first, then smallest node
  std::int32_t node;
  std::int32_t triangle;

  bool operator<(const Candidate& o) const { return order < o.order; }
};

Candidate makeCandidate(const NodeError& worst, std::int32_t triangle) {
  std::uint32_t bits = 0; // those of floats >= 0 are in the order of their values
  std::memcpy(&bits, &worst.error, sizeof bits);
  return {std::uint64_t(~bits) << 32 | std::uint32_t(worst.node), worst.node, triangle};
}

/// Garland & Heckbert, "Fast polygonal approximation of terrains and height fields" (1995), with
/// rounds in the place of the heap: all changed triangles are scanned, their worst nodes sorted,
/// and those go in whose triangle is still the one that was scanned.
class Greedy final : public Simplifier {
 public:
  explicit Greedy(const MethodOptions& options) : options_(options) {}

  Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                  const LevelParams& level, Tin& out) override;

 private:
  void start(const Border& border, int baseGrid);
  void seed(double tolerance);
  void insertNode(int i, int j, std::int32_t hint);
  bool insertAtFreePlace(const Candidate& candidate);
  void maskBorder();
  float scanTolerance(double maxError) const;
  template <class Scan, class Insert> bool refine(Scan scan, Insert insert);
  NodeError exactWorst(std::int32_t t, double tolerance) const;
  void countPlaces();
  void markAllChanged();
  ErrorMeasure finish(const LevelParams& level, Tin& out);
  ErrorMeasure leaveForbiddenCount(const LevelParams& level, Tin& out);
  void report(const ErrorMeasure& measure, const LevelParams& level, Tin& out) const;

  MethodOptions options_;
  const HeightTile* tile_ = nullptr;
  const TileFrame* frame_ = nullptr;
  bool severalPlaces_ = false; ///< a node may have more than one of its places
  NodeMesh nodes_;
  Triangulation& mesh_ = nodes_.triangulation();
  NodeHeights heights_;
  Decimator decimator_;
  std::vector<double> nodeV_;
  std::unique_ptr<SpanList<double>> spans_ = std::make_unique<SpanList<double>>();
  std::vector<Candidate> candidates_;
  std::vector<std::int32_t> scanList_;
  std::vector<std::uint8_t> places_; ///< by node: which of its four places have a vertex, as bits
};

Status Greedy::simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                        const LevelParams& level, Tin& out) {
  assert(tile.cells() == frame.cells());
  tile_ = &tile;
  frame_ = &frame;
  severalPlaces_ = frame.heightStep() <= level.maxError; // else rounded heights are in the way
  heights_.reset(tile, frame);
  start(border, level.baseGrid);
  const float tolerance = scanTolerance(level.maxError);
  seed(tolerance);
  refine(
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
  ErrorMeasure measure = finish(level, out);
  if (out.vertices.size() == kForbiddenVertexCount)
    measure = leaveForbiddenCount(level, out);
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
  nodeV_.clear();
  for (int j = 0; j <= n; ++j)
    nodeV_.push_back(frame_->nodeV(j));
  nodeV_.resize(nodeV_.size() + kLanePadding, kQuantizedMax);
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

/// Makes a node a vertex, or gives one that is another vertex, at the nearest free of the four
/// quantized places around its real position. With all four it lies on a level square, whatever the
/// slopes around: so rounding of places never keeps a node from the max error. False where none is
/// free.
bool Greedy::insertAtFreePlace(const Candidate& candidate) {
  const int i = heights_.column(candidate.node), j = heights_.row(candidate.node);
  std::uint8_t& used = places_[std::size_t(candidate.node)];
  const int west = int(frame_->nodeU(i)), south = int(frame_->nodeV(j));
  const double du = frame_->nodeU(i) - west, dv = frame_->nodeV(j) - south;
  int best = -1;
  double nearest = 0;
  for (int place = 0; place < 4; ++place) {
    const int east = place & 1, north = place >> 1;
    const double distance = std::abs(du - east) + std::abs(dv - north);
    if ((used >> place & 1) == 0 && (best < 0 || distance < nearest)) {
      best = place;
      nearest = distance;
    }
  }
  if (best < 0)
    return false;
  used = severalPlaces_ ? std::uint8_t(used | 1 << best) : kAllPlaces;
  mesh_.insert(nodes_.makeVertex(i, j, west + (best & 1), south + (best >> 1)), candidate.triangle);
  heights_.mask(i, j);
  return true;
}

/// Which places the vertices of the mesh take.
void Greedy::countPlaces() {
  const int n = frame_->cells();
  places_.assign(std::size_t(heights_.index(n, n)) + 1, 0);
  for (std::size_t v = 0; v < mesh_.vertices().size(); ++v) {
    if (mesh_.leaving(std::int32_t(v)) == Triangulation::kNone)
      continue;
    const NodeVertex& vertex = mesh_.vertices()[v];
    const int east = vertex.corner.u - int(frame_->nodeU(vertex.i));
    const int north = vertex.corner.v - int(frame_->nodeV(vertex.j));
    std::uint8_t& used = places_[std::size_t(heights_.index(vertex.i, vertex.j))];
    used = severalPlaces_ ? std::uint8_t(used | 1 << (2 * north + east)) : kAllPlaces;
  }
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

/// The max error less what the float32 arithmetic of the scan may get wrong.
float Greedy::scanTolerance(double maxError) const {
  const double margin = double(heights_.range()) / (1 << 21);
  return float(maxError - std::min(margin, maxError / 16));
}

/// Rounds of scanning what has changed and inserting what was found, until there is nothing to
/// insert. True when any node went in.
template <class Scan, class Insert> bool Greedy::refine(Scan scan, Insert insert) {
  bool any = false;
  while (!mesh_.changed().empty()) {
    scanList_.swap(mesh_.changed());
    mesh_.changed().clear();
    candidates_.clear();
    for (const std::int32_t t : scanList_) {
      mesh_.clearChanged(t);
      const NodeError worst = scan(t);
      if (worst.node >= 0)
        candidates_.push_back(makeCandidate(worst, t));
    }
    std::sort(candidates_.begin(), candidates_.end());
    for (const Candidate& candidate : candidates_) {
      if (!mesh_.isChanged(candidate.triangle) && insert(candidate))
        any = true;
    }
  }
  return any;
}

/// The inner node of a triangle with the largest error above the tolerance, in the arithmetic of
/// measureError(); one with all its places taken has no say.
NodeError Greedy::exactWorst(std::int32_t t, double tolerance) const {
  SpanCorner corners[3];
  for (int k = 0; k < 3; ++k) {
    corners[k] = mesh_.cornerOf(t, k).corner;
    corners[k].height = frame_->decode(mesh_.cornerOf(t, k).q);
  }
  const int cells = frame_->cells();
  const double slope = heightPerColumn(corners[0], corners[1], corners[2], unitsPerColumn(cells));
  listSpans(corners[0], corners[1], corners[2], nodeV_.data(), slope, *spans_);
  NodeError found;
  double worst = tolerance;
  for (int r = 0; r < spans_->rows; ++r) {
    const int j = spans_->firstRow + r;
    for (int i = spans_->begin[r]; i < spans_->begin[r] + spans_->count[r]; ++i) {
      const double error =
          std::abs(spans_->height[r] + (i - spans_->begin[r]) * slope - tile_->at(i, j));
      const bool inner = i > 0 && j > 0 && i < cells && j < cells;
      if (error > worst && inner && places_[std::size_t(heights_.index(i, j))] != kAllPlaces) {
        worst = error;
        found = {heights_.index(i, j), float(error)};
      }
    }
  }
  return found;
}

/// Writes the TIN, and as long as the exact measure finds nodes beyond the max error goes on.
ErrorMeasure Greedy::finish(const LevelParams& level, Tin& out) {
  while (true) {
    nodes_.write(out);
    const ErrorMeasure measure = measureError(*tile_, *frame_, out);
    if (measure.max <= level.maxError)
      return measure;
    markAllChanged();
    countPlaces();
    const double tolerance = level.maxError * (1 - kRoundingSlack);
    const bool inserted =
        refine([&](std::int32_t t) { return exactWorst(t, tolerance); },
               [&](const Candidate& candidate) { return insertAtFreePlace(candidate); });
    if (!inserted)
      return measure;
  }
}

void Greedy::markAllChanged() {
  for (std::int32_t t = 0; t < mesh_.triangleSlots(); ++t) {
    if (mesh_.alive(t))
      mesh_.markChanged(t);
  }
}

/// A mesh of 65536 vertices gets one more, the worst node of all, or has to do with one less.
ErrorMeasure Greedy::leaveForbiddenCount(const LevelParams& level, Tin& out) {
  countPlaces();
  Candidate worst{~std::uint64_t(0), -1, 0};
  for (std::int32_t t = 0; t < mesh_.triangleSlots(); ++t) {
    const NodeError found = mesh_.alive(t) ? exactWorst(t, -1) : NodeError{};
    if (found.node >= 0)
      worst = std::min(worst, makeCandidate(found, t));
  }
  if (worst.node >= 0 && insertAtFreePlace(worst))
    return finish(level, out);
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
