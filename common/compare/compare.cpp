// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "compare/compare.h"

#include <cmath>
#include <functional>

#include "compare/method_trial.h"
#include "compare/monotone_search.h"
#include "pyramid/sample_tiles.h"

namespace qmesh {

namespace {

/// How near a method is brought to its target.
constexpr double kTolerance = 0.01;
constexpr const char* kMaxErrorOption = "max-error";

/// One method's way to its three rows.
class MethodComparer {
 public:
  MethodComparer(const std::vector<NodeWindow>& windows, const TilesetInput& input,
                 const SimplifierInfo& info, Comparison& comparison)
      : trial_(windows, input, info, info.mainOption),
        bounded_(windows, input, info, kMaxErrorOption), comparison_(comparison) {}

  /// `step` is told after each trial and returns false to stop.
  Status run(const std::function<bool()>& step) {
    step_ = step;
    for (const CompareTarget target :
         {CompareTarget::defaults, CompareTarget::count, CompareTarget::error}) {
      auto row = target == CompareTarget::defaults ? trial_.measure("") : tuned(target);
      if (!row.ok())
        return row.status();
      comparison_.targets[std::size_t(target)].push_back(*std::move(row));
    }
    return {};
  }

 private:
  static double outcomeOf(const TrialOutcome& outcome, CompareTarget target) {
    return target == CompareTarget::count ? double(outcome.triangles) : outcome.maxError;
  }

  /// The row at the value of an option that comes nearest to the target.
  Result<ComparedMethod> tuned(CompareTarget target) {
    const double wanted =
        target == CompareTarget::count ? double(comparison_.triangles) : comparison_.maxError;
    const auto usual = trial_.run("");
    if (!usual.ok())
      return usual.status();
    const double miss = std::abs(outcomeOf(*usual, target) - wanted);
    if (!trial_.canBeTuned() || wanted <= 0 || miss == 0) {
      auto row = trial_.measure("");
      if (row.ok())
        row->reached = miss <= kTolerance * wanted;
      return row;
    }
    auto row = tunedBy(trial_, target, wanted);
    if (!row.ok() || target == CompareTarget::count || row->option == kMaxErrorOption)
      return row;
    auto bounded = tunedBy(bounded_, target, wanted);
    const bool better =
        bounded.ok() && bounded->reached && (!row->reached || bounded->triangles < row->triangles);
    return better || !bounded.ok() ? bounded : row;
  }

  Result<ComparedMethod> tunedBy(MethodTrial& trial, CompareTarget target, double wanted) {
    const MethodTrial::Scale scale = trial.scale();
    const auto found =
        searchMonotone(scale.low, scale.high, wanted, kTolerance, [&](double x) -> Result<double> {
          if (!step_())
            return Status(Code::interrupted, "stopped before the comparison was complete");
          const auto outcome = trial.run(scale.valueText(x));
          return outcome.ok() ? Result<double>(outcomeOf(*outcome, target))
                              : Result<double>(outcome.status());
        });
    if (!found.ok())
      return found.status();
    auto row = trial.measure(scale.valueText(found->value));
    if (row.ok())
      row->reached = found->reached;
    return row;
  }

  MethodTrial trial_;
  MethodTrial bounded_; ///< by the max error, which some methods take beside their own option
  Comparison& comparison_;
  std::function<bool()> step_;
};

Result<std::vector<NodeWindow>> loadTiles(const TilesetInput& input,
                                          const std::vector<TileId>& tiles) {
  auto nodes = input.source.open(input.plan.lattice(tiles.front().z));
  if (!nodes.ok())
    return nodes.status();
  std::vector<NodeWindow> windows(tiles.size());
  for (std::size_t k = 0; k < tiles.size(); ++k)
    QMESH_RETURN_IF_ERROR(sampleTile(input, **nodes, tiles[k], windows[k]));
  return windows;
}

Result<TileId> busiestTile(const TilesetInput& input) {
  const std::vector<TileId> tiles =
      spreadTiles(input.plan.tiles, input.plan.maxZoom, kTilesLookedAt);
  auto nodes = input.source.open(input.plan.lattice(input.plan.maxZoom));
  if (!nodes.ok())
    return nodes.status();
  TileId busiest = tiles.front();
  std::uint64_t most = 0;
  const auto method = chosenSimplifier(input.options.method);
  if (!method.ok())
    return method.status();
  std::vector<NodeWindow> window(1);
  for (const TileId id : tiles) {
    QMESH_RETURN_IF_ERROR(sampleTile(input, **nodes, id, window.front()));
    MethodTrial trial(window, input, **method, "");
    const auto outcome = trial.run("");
    if (!outcome.ok())
      return outcome.status();
    if (outcome->triangles > most) {
      most = outcome->triangles;
      busiest = id;
    }
  }
  return busiest;
}

} // namespace

Result<std::vector<TileId>> chooseComparedTiles(const TilesetInput& input) {
  const TilingOptions& options = input.options.tiling;
  const int zoom = input.plan.maxZoom;
  if (!options.minX && !options.maxX && !options.minY && !options.maxY) {
    const auto busiest = busiestTile(input);
    return busiest.ok() ? Result<std::vector<TileId>>(std::vector<TileId>{*busiest})
                        : Result<std::vector<TileId>>(busiest.status());
  }
  if (input.plan.tiles.count(zoom) > kMostComparedTiles)
    return Status(Code::usage, "--compare works on " + std::to_string(kMostComparedTiles) +
                                   " tiles at most; choose fewer by --min-x, --max-x, --min-y and "
                                   "--max-y, or one by --compare-tile");
  std::vector<TileId> tiles;
  for (const TileRange& r : input.plan.tiles.ranges(zoom)) {
    for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
      for (std::uint32_t x = r.x0; x <= r.x1; ++x)
        tiles.push_back({zoom, x, y});
    }
  }
  return tiles;
}

Result<Comparison> compareMethods(const TilesetInput& input, const std::vector<TileId>& tiles,
                                  const Progress& progress) {
  const auto windows = loadTiles(input, tiles);
  if (!windows.ok())
    return windows.status();
  Comparison comparison;
  comparison.tiles = tiles;
  const auto method = chosenSimplifier(input.options.method);
  if (!method.ok())
    return method.status();
  const auto reference = MethodTrial(*windows, input, **method, "").run("");
  if (!reference.ok())
    return reference.status();
  comparison.triangles = reference->triangles;
  comparison.maxError = reference->maxError;
  const double count = double(simplifiers().size());
  double done = 0;
  for (const SimplifierInfo& info : simplifiers()) {
    QMESH_RETURN_IF_ERROR(MethodComparer(*windows, input, info, comparison).run([&] {
      return !progress || progress(done / count);
    }));
    done += 1;
  }
  if (progress)
    progress(1);
  return comparison;
}

} // namespace qmesh
