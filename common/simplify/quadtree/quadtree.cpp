// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <vector>

#include "border/dyadic_border.h"
#include "border/edge_profile.h"
#include "simplify/exact_refinement.h"
#include "simplify/finish.h"
#include "simplify/methods.h"
#include "simplify/node_heights.h"
#include "simplify/quadtree/curvature.h"
#include "simplify/quadtree/observer.h"
#include "simplify/quadtree/quadtree_mesh.h"

namespace qmesh {

namespace {

/// The default curvature in max errors per node spacing: makes about as many triangles as greedy
/// (docs/algorithms/quadtree.md).
constexpr double kDefaultCurvature = 120;

/// Cifuentes, Venere & Clausse, "Interactive remeshing for navigation over landscape models"
/// (2010): a restricted quadtree whose cells are divided where the terrain is curved, or, where a
/// max error is asked for and no curvature, where the mesh is beyond it.
class Quadtree final : public Simplifier {
 public:
  explicit Quadtree(const MethodOptions& options)
      : curvatureSpec_(options.curvature), byMaxError_(options.maxError.isSet()),
        observer_(options) {}

  void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                  Border& border) const override;

  Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                  const LevelParams& level, Tin& out) override;

 private:
  Result<std::optional<double>> threshold(const HeightTile& tile, const LevelParams& level) const;
  void divideByCurvature(const HeightTile& tile, double threshold);
  void divideByError(const HeightTile& tile, const TileFrame& frame, double maxError);
  bool divideBadLeaves(const HeightTile& tile, float tolerance);
  void addLeavesAround(int i, int j);
  double factorOf(const HeightTile& tile, std::int32_t triangle) const;
  void maskVertices(int cells);

  LevelSpec curvatureSpec_;
  bool byMaxError_; ///< unless there is a SPEC
  Observer observer_;
  Curvature curvature_;
  CumulatedCurvature cumulated_;
  RestrictedQuadtree tree_;
  QuadtreeMesh mesh_;
  std::vector<QuadCell> bad_;
  NodeHeights heights_;
  ExactRefinement exact_;
};

/// The cumulated curvature at which cells are divided; nothing where the max error decides.
Result<std::optional<double>> Quadtree::threshold(const HeightTile& tile,
                                                  const LevelParams& level) const {
  auto spec = curvatureSpec_.find(level.zoom);
  if (!spec.ok() || *spec || byMaxError_)
    return spec;
  const double spacing = tile.lattice().scheme().tileMetres(level.zoom) / tile.cells();
  return std::optional<double>(kDefaultCurvature * level.maxError / spacing);
}

/// A stretch of an edge is halved like a cell of that size, of which it is all the neighbour knows:
/// as if the cell were as curved everywhere as along the edge.
void Quadtree::makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                          Border& border) const {
  const int n = tile.cells();
  const auto stretchFactor = [&](const EdgeStretch& s) {
    const int length = s.to - s.from;
    if (s.edge == kSouth || s.edge == kNorth)
      return observer_.factor(tile, s.from, s.edge == kNorth ? n : 0, length, 0);
    return observer_.factor(tile, s.edge == kEast ? n : 0, s.from, 0, length);
  };
  // A SPEC without a value here is reported by simplify(), which gets no further.
  const auto curved = threshold(tile, level);
  if (!curved.ok() || !*curved) {
    const double tolerance = borderTolerance(level);
    const auto beyondError = [&](const EdgeStretch& s) {
      const bool canGain = s.to - s.from > 1 || !observer_.exists();
      return canGain && s.error > tolerance * stretchFactor(s);
    };
    makeDyadicBorder(tile, frame, level, beyondError, border);
    return;
  }
  Curvature curvature;
  curvature.reset(tile);
  const auto tooCurved = [&](const EdgeStretch& s) {
    if (s.to - s.from == 1)
      return false;
    double sum = 0;
    for (int k = s.from; k <= s.to; ++k) {
      const bool alongRow = s.edge == kSouth || s.edge == kNorth;
      const int across = s.edge == kEast || s.edge == kNorth ? n : 0;
      sum += alongRow ? curvature.kappa(k, across) : curvature.kappa(across, k);
    }
    return sum * (s.to - s.from + 1) > **curved * stretchFactor(s);
  };
  makeDyadicBorder(tile, frame, level, tooCurved, border);
}

Status Quadtree::simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                          const LevelParams& level, Tin& out) {
  const auto curved = threshold(tile, level);
  if (!curved.ok())
    return curved.status();
  tree_.reset(frame.cells(), level.baseGrid);
  mesh_.reset(tile, frame, border);
  mesh_.followBorder(tree_);
  if (*curved) {
    divideByCurvature(tile, **curved);
    mesh_.build(tree_);
    mesh_.nodes().write(out);
    finishTin(tile, frame, level, StopReason::parameter, out);
    return {};
  }
  divideByError(tile, frame, level.maxError);
  if (observer_.exists()) {
    mesh_.nodes().write(out);
  } else {
    mesh_.nodes().triangulation().limitFlips(BaseGrid(frame, level));
    exact_.reset(tile, frame, level.maxError);
    exact_.run(mesh_.nodes(), out);
  }
  finishTin(tile, frame, level, observer_.exists() ? StopReason::parameter : StopReason::maxError,
            out);
  return {};
}

/// A cell is divided while its cumulated curvature exceeds the threshold.
void Quadtree::divideByCurvature(const HeightTile& tile, double threshold) {
  curvature_.reset(tile);
  cumulated_.reset(tile, curvature_);
  std::vector<QuadCell> open;
  tree_.forEachLeaf([&](const QuadCell& leaf) { open.push_back(leaf); });
  while (!open.empty()) {
    const QuadCell cell = open.back();
    open.pop_back();
    if (cell.size == 1)
      continue;
    const double factor = observer_.factor(tile, cell.i, cell.j, cell.size, cell.size);
    const bool divides = cumulated_.ofCell(cell.i, cell.j, cell.size) > threshold * factor;
    if (divides && tree_.leafSize(cell.i, cell.j) == cell.size)
      tree_.divide(cell.i, cell.j);
    // Others may have divided it, too: what came of it is looked at all the same.
    if (tree_.leafSize(cell.i, cell.j) == cell.size)
      continue;
    const int half = cell.size / 2;
    for (const int dj : {0, half}) {
      for (const int di : {0, half})
        open.push_back({cell.i + di, cell.j + dj, half});
    }
  }
}

/// Builds the mesh, divides the leaves with nodes it is too far from, and builds it again until
/// there are none.
void Quadtree::divideByError(const HeightTile& tile, const TileFrame& frame, double maxError) {
  heights_.reset(tile, frame);
  do {
    mesh_.build(tree_);
    maskVertices(frame.cells());
  } while (divideBadLeaves(tile, heights_.scanTolerance(maxError)));
}

/// Vertices are where they are, and the border is not ours to mend.
void Quadtree::maskVertices(int cells) {
  for (int k = 0; k <= cells; ++k) {
    heights_.mask(k, 0);
    heights_.mask(k, cells);
    heights_.mask(0, k);
    heights_.mask(cells, k);
  }
  for (const NodeVertex& vertex : mesh_.nodes().triangulation().vertices())
    heights_.mask(vertex.i, vertex.j);
}

/// True when a leaf was divided. Each is divided once at most: its quarters may do.
bool Quadtree::divideBadLeaves(const HeightTile& tile, float tolerance) {
  bad_.clear();
  const Triangulation& mesh = mesh_.nodes().triangulation();
  for (std::int32_t t = 0; t < mesh.triangleSlots(); ++t) {
    if (!mesh.alive(t))
      continue;
    const NodeError worst = heights_.worst(
        mesh.cornerOf(t, 0).corner, mesh.cornerOf(t, 1).corner, mesh.cornerOf(t, 2).corner,
        observer_.exists() ? tolerance * float(factorOf(tile, t)) : tolerance);
    if (worst.node >= 0)
      addLeavesAround(heights_.column(worst.node), heights_.row(worst.node));
  }
  for (const QuadCell& leaf : bad_) {
    if (tree_.leafSize(leaf.i, leaf.j) == leaf.size)
      tree_.divide(leaf.i, leaf.j);
  }
  return !bad_.empty();
}

/// The leaves around an inner node that is no vertex: they are wider than one cell.
void Quadtree::addLeavesAround(int i, int j) {
  for (const int dj : {0, -1}) {
    for (const int di : {0, -1}) {
      if (tree_.leafSize(i + di, j + dj) > 1)
        bad_.push_back(tree_.leafAt(i + di, j + dj));
    }
  }
}

/// The observer's factor for the box around a triangle.
double Quadtree::factorOf(const HeightTile& tile, std::int32_t triangle) const {
  const Triangulation& mesh = mesh_.nodes().triangulation();
  int west = tile.cells(), south = west, east = 0, north = 0;
  for (int k = 0; k < 3; ++k) {
    const NodeVertex& corner = mesh.cornerOf(triangle, k);
    west = std::min(west, int(corner.i));
    east = std::max(east, int(corner.i));
    south = std::min(south, int(corner.j));
    north = std::max(north, int(corner.j));
  }
  return observer_.factor(tile, west, south, east - west, north - south);
}

} // namespace

std::unique_ptr<Simplifier> createQuadtree(const MethodOptions& options) {
  return std::make_unique<Quadtree>(options);
}

} // namespace qmesh
