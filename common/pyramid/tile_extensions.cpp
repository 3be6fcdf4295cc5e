// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/tile_extensions.h"

#include <algorithm>

#include "codec/metadata.h"

namespace qmesh {

namespace {

/// Normals of the DEM at the vertices, by the name that CesiumJS knows.
class NormalsProvider : public ExtensionProvider {
 public:
  void announce(LayerJson& layer) const override { layer.extensions.push_back("octvertexnormals"); }
  void provide(const ExtensionInput& input, TileExtensions& extensions) const override {
    extensions.normals = octNormals(input.tile, input.frame, input.tin);
  }
};

/// Tiles of every `step`-th zoom list which descendants exist in the next `step` zooms.
class MetadataProvider : public ExtensionProvider {
 public:
  explicit MetadataProvider(int step) : step_(step) {}

  void announce(LayerJson& layer) const override {
    layer.extensions.push_back("metadata");
    layer.metadataAvailability = step_;
  }

  void provide(const ExtensionInput& input, TileExtensions& extensions) const override {
    const TileId id = input.tile.id();
    if (!input.kept || id.z % step_ != 0)
      return;
    std::vector<std::vector<TileRange>> levels;
    for (int zoom = id.z + 1; zoom <= std::min(id.z + step_, input.kept->maxZoom()); ++zoom)
      levels.push_back(input.kept->rangesUnder(id, zoom));
    extensions.metadata = metadataJson(levels);
  }

 private:
  int step_;
};

} // namespace

std::vector<std::unique_ptr<const ExtensionProvider>>
extensionProviders(const OutputOptions& options) {
  std::vector<std::unique_ptr<const ExtensionProvider>> providers;
  if (options.normals)
    providers.push_back(std::make_unique<NormalsProvider>());
  if (options.metadata > 0)
    providers.push_back(std::make_unique<MetadataProvider>(options.metadata));
  return providers;
}

} // namespace qmesh
