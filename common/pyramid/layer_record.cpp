// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/layer_record.h"

#include <cstdio>

#include "pyramid/tile_extensions.h"

namespace qmesh {

namespace {

std::string versionOf(std::uint64_t contentHash) {
  char text[32];
  std::snprintf(text, sizeof text, "1.0.0-%016llx", static_cast<unsigned long long>(contentHash));
  return text;
}

/// Bounds in -180..180: the whole round where the data crosses the antimeridian, because readers
/// of bounds take west for the lesser number.
GeoBox simpleBounds(const GeoBox& box) {
  const bool crosses = box.east > 180 || box.east - box.west >= 360;
  return {crosses ? -180 : box.west, box.south, crosses ? 180 : box.east, box.north};
}

std::string baseName(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = file.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? file : file.substr(0, dot);
}

} // namespace

LayerJson layerRecord(const TilesetOptions& options, const PyramidPlan& plan,
                      const Availability& kept, const BuildReport& report) {
  LayerJson layer;
  layer.name = options.output.title.empty() ? baseName(options.input.path) : options.output.title;
  layer.version = versionOf(report.contentHash);
  layer.attribution = options.output.copyright;
  layer.profile = plan.scheme.profile();
  layer.slippyMap = options.output.xyz;
  layer.bounds = simpleBounds(plan.bounds);
  layer.minZoom = plan.minZoom;
  layer.maxZoom = kept.maxZoom();
  for (int z = 0; z <= layer.maxZoom; ++z)
    layer.available.push_back(kept.ranges(z));
  for (const auto& provider : extensionProviders(options.output))
    provider->announce(layer);
  layer.generator = "gdal2qmesh " QMESH_VERSION;
  layer.method = options.method.name;
  layer.cellsPerTile = plan.cells;
  layer.extent = plan.bounds;
  for (int z = plan.minZoom; z <= plan.maxZoom; ++z) {
    const std::size_t k = std::size_t(z);
    layer.levels.push_back({z, report.maxErrors[k], report.levels[k].maxError});
  }
  return layer;
}

} // namespace qmesh
