// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <limits>

#include "mesh/base_grid.h"
#include "simplify/finish.h"
#include "simplify/methods.h"
#include "simplify/metric_scale.h"
#include "simplify/node_mesh.h"
#include "simplify/qem/edge_collapser.h"

namespace qmesh {

namespace {

/// Where nothing is asked for: the smallest visible object in max errors of the level, so that
/// there are about as many triangles as greedy makes (docs/algorithms/qem.md).
constexpr double kSvoPerMaxError = 0.65;

/// Garland & Heckbert, "Surface simplification using quadric error metrics" (1997), on the grid of
/// all nodes; stops as Ai et al., "Continuous-scale 3D terrain visualization based on a
/// detail-increment model" (2019), at the smallest visible object.
class Qem final : public Simplifier {
 public:
  explicit Qem(const MethodOptions& options) : options_(options) {}

  Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                  const LevelParams& level, Tin& out) override;

 private:
  /// When to stop.
  struct Stop {
    double svo;           ///< metres
    std::size_t vertices; ///< left
  };

  Result<Stop> stopAt(const LevelParams& level, int cells) const;
  void markStaying(const BaseGrid& grid);

  MethodOptions options_;
  NodeMesh nodes_;
  EdgeCollapser collapser_;
  std::vector<std::uint8_t> stays_;
};

/// The first of the thresholds that were asked for counts; the SVO has a default where none was.
Result<Qem::Stop> Qem::stopAt(const LevelParams& level, int cells) const {
  const auto svo = options_.svo.find(level.zoom);
  if (!svo.ok())
    return svo.status();
  const auto ratio = options_.ratio.find(level.zoom);
  if (!ratio.ok())
    return ratio.status();
  const double all = double(cells + 1) * (cells + 1);
  const double otherwise =
      *ratio ? std::numeric_limits<double>::infinity() : kSvoPerMaxError * level.maxError;
  return Stop{svo->value_or(otherwise), std::size_t(ratio->value_or(0) * all)};
}

/// The edges' vertices and the nodes of the base grid.
void Qem::markStaying(const BaseGrid& grid) {
  stays_.clear();
  for (const NodeVertex& vertex : nodes_.triangulation().vertices())
    stays_.push_back(!isInner(vertex.corner) || grid.isNode(vertex.i, vertex.j) ? 1 : 0);
}

Status Qem::simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                     const LevelParams& level, Tin& out) {
  const Result<Stop> stop = stopAt(level, frame.cells());
  if (!stop.ok())
    return stop.status();
  nodes_.resetToAllNodes(tile, frame, border);
  const BaseGrid grid(frame, level);
  markStaying(grid);
  collapser_.reset(nodes_.triangulation(), metricScale(tile), stays_, grid);
  while (collapser_.vertices() > stop->vertices && collapser_.findNext() &&
         collapser_.nextSvo() <= stop->svo)
    collapser_.collapse();
  nodes_.triangulation().forgetChanges();
  nodes_.write(out);
  finishTin(tile, frame, level, StopReason::parameter, out);
  return {};
}

} // namespace

std::unique_ptr<Simplifier> createQem(const MethodOptions& options) {
  return std::make_unique<Qem>(options);
}

} // namespace qmesh
