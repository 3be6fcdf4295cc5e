// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/pyramid_plan.h"

#include <algorithm>
#include <cmath>

#include "simplify/method_specs.h"

namespace qmesh {

namespace {

/// At the deepest zooms half a pixel is less than the format's 15 bits hold, metres.
constexpr double kLeastDefaultError = 0.002;

/// The zooms of the run: -z, else 0 and the native zoom.
Status chooseZooms(const TilingOptions& options, const NodeSourceFactory& source,
                   PyramidPlan& plan) {
  const int native = source.nativeZoom(plan.scheme, plan.cells);
  plan.minZoom = options.minZoom.value_or(0);
  plan.maxZoom = options.maxZoom.value_or(native);
  if (!options.maxZoom && plan.minZoom > native) {
    return {Code::usage, "the minimum zoom " + std::to_string(plan.minZoom) +
                             " is above the DEM's native zoom " + std::to_string(native) +
                             "; to go there all the same say it: -z " +
                             std::to_string(plan.minZoom)};
  }
  if (plan.minZoom > plan.maxZoom) {
    return {Code::usage, "the minimum zoom " + std::to_string(plan.minZoom) +
                             " is above the maximum zoom " + std::to_string(plan.maxZoom)};
  }
  return {};
}

/// Max error of every level: --max-error as it is said, else from --screen-error; the finest level,
/// which clients stretch when one goes closer, takes half.
Status chooseLevels(const MethodOptions& options, PyramidPlan& plan) {
  const bool fromScreen = !options.maxError.isSet();
  QMESH_RETURN_IF_ERROR(checkSpecs(options, plan.minZoom, plan.maxZoom));
  const LevelSpec& spec = fromScreen ? options.screenError : options.maxError;
  for (int zoom = 0; zoom <= plan.maxZoom; ++zoom) {
    double value = zoom >= plan.minZoom ? *spec.at(zoom) : 0;
    if (fromScreen) {
      value *= plan.scheme.geometricError(zoom) / 2;
      if (zoom == plan.maxZoom)
        value /= 2;
      value = std::max(value, kLeastDefaultError);
    }
    plan.levels.push_back(levelParams(plan.scheme, zoom, value, plan.cells));
  }
  return {};
}

/// An interval that ends so close to a tile's edge, in tiles, ends there: extents of projected
/// rasters carry rounding noise.
constexpr double kEdgeTolerance = 1e-9;

/// First and last tile that an open interval of fractions meets.
std::pair<std::uint32_t, std::uint32_t> meet(double from, double to, std::uint32_t tiles) {
  const double last = double(tiles) - 1;
  const double a = std::clamp(std::floor(from * tiles + kEdgeTolerance), 0.0, last);
  const double b = std::clamp(std::ceil(to * tiles - kEdgeTolerance) - 1, a, last);
  return {std::uint32_t(a), std::uint32_t(b)};
}

/// Adds the tiles of the finest level that one box (not across the antimeridian) meets.
void addBox(const TilingOptions& options, const GeoBox& box, PyramidPlan& plan) {
  const int z = plan.maxZoom;
  const double south = plan.scheme.fractionY(box.south);
  const double north = plan.scheme.fractionY(box.north);
  if (north <= 0 || south >= 1)
    return;
  const auto x =
      meet(plan.scheme.fractionX(box.west), plan.scheme.fractionX(box.east), plan.scheme.tilesX(z));
  const auto y = meet(south, north, plan.scheme.tilesY(z));
  const auto low = [](std::uint32_t v, const std::optional<std::int64_t>& bound) {
    return std::max<std::int64_t>(v, bound.value_or(0));
  };
  const auto high = [](std::uint32_t v, const std::optional<std::int64_t>& bound) {
    return std::min<std::int64_t>(v, bound.value_or(v));
  };
  const std::int64_t x0 = low(x.first, options.minX), x1 = high(x.second, options.maxX);
  const std::int64_t y0 = low(y.first, options.minY), y1 = high(y.second, options.maxY);
  if (x0 > x1 || y0 > y1)
    return;
  plan.tiles.add(z, {std::uint32_t(x0), std::uint32_t(y0), std::uint32_t(x1), std::uint32_t(y1)});
}

void addBoxAcrossAntimeridian(const TilingOptions& options, const GeoBox& box, PyramidPlan& plan) {
  if (box.east - box.west >= 360) {
    addBox(options, {-180, box.south, 180, box.north}, plan);
  } else if (box.east > 180) {
    addBox(options, {box.west, box.south, 180, box.north}, plan);
    addBox(options, {-180, box.south, box.east - 360, box.north}, plan);
  } else {
    addBox(options, box, plan);
  }
}

void addAncestorsAndRoots(PyramidPlan& plan) {
  plan.dataTiles = plan.tiles.ranges(plan.maxZoom);
  plan.support = plan.tiles;
  for (int z = plan.maxZoom; z > 0; --z) {
    for (const TileRange& r : plan.support.ranges(z)) {
      const TileRange parents{r.x0 / 2, r.y0 / 2, r.x1 / 2, r.y1 / 2};
      plan.support.add(z - 1, parents);
      if (z > plan.minZoom)
        plan.tiles.add(z - 1, parents);
    }
  }
  const TileRange roots{0, 0, plan.scheme.tilesX(0) - 1, 0};
  plan.support.add(0, roots);
  if (plan.minZoom == 0)
    plan.tiles.add(0, roots);
}

GeoBox hull(const std::vector<GeoBox>& boxes) {
  GeoBox all = boxes.front();
  for (const GeoBox& b : boxes) {
    all = {std::min(all.west, b.west), std::min(all.south, b.south), std::max(all.east, b.east),
           std::max(all.north, b.north)};
  }
  return all;
}

} // namespace

std::uint64_t PyramidPlan::tileCount() const {
  std::uint64_t count = 0;
  for (int z = minZoom; z <= maxZoom; ++z)
    count += tiles.count(z);
  return count;
}

Result<PyramidPlan> planPyramid(const TilesetOptions& options, const NodeSourceFactory& source) {
  PyramidPlan plan;
  plan.scheme = Scheme(options.tiling.profile);
  plan.cells = options.tiling.tileSize;
  QMESH_RETURN_IF_ERROR(chooseZooms(options.tiling, source, plan));
  QMESH_RETURN_IF_ERROR(chooseLevels(options.method, plan));
  if (source.extent().empty())
    return Status(Code::input, options.input.path + ": covers no area");
  for (const GeoBox& box : source.extent())
    addBoxAcrossAntimeridian(options.tiling, box, plan);
  if (plan.tiles.count(plan.maxZoom) == 0) {
    const TilingOptions& tiling = options.tiling;
    const bool chosen = tiling.minX || tiling.maxX || tiling.minY || tiling.maxY;
    return Status(chosen ? Code::usage : Code::input,
                  chosen ? "no tile of zoom " + std::to_string(plan.maxZoom) +
                               " within --min-x, --max-x, --min-y and --max-y, or --compare-tile, "
                               "meets the data"
                         : options.input.path + ": lies outside the tile matrix of the profile");
  }
  plan.bounds = hull(source.extent());
  addAncestorsAndRoots(plan);
  return plan;
}

} // namespace qmesh
