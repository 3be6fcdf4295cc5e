// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/layer_json.h"
#include "require.h"

namespace {

using qmesh::fuzz::require;

void requireValid(const qmesh::LayerJson& layer) {
  require(!layer.tiles.empty(), "a pattern of addresses");
  require(layer.available.size() <= qmesh::kMaxZoom + 1, "no level too deep");
  const qmesh::Scheme scheme(layer.profile);
  for (std::size_t zoom = 0; zoom < layer.available.size(); ++zoom)
    for (const qmesh::TileRange& range : layer.available[zoom])
      require(range.x0 <= range.x1 && range.x1 < scheme.tilesX(int(zoom)) && range.y0 <= range.y1 &&
                  range.y1 < scheme.tilesY(int(zoom)),
              "ranges within the level");
}

} // namespace

/// Any text: reading ends in an error or a layer within limits, and what is written reads back.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto layer = qmesh::readLayerJson(std::string(data, data + size));
  if (!layer.ok())
    return 0;
  requireValid(*layer);
  const std::string text = qmesh::writeLayerJson(*layer);
  const auto again = qmesh::readLayerJson(text);
  require(again.ok(), "our own text can be read");
  require(qmesh::writeLayerJson(*again) == text, "writing what was read gives the text back");
  return 0;
}
