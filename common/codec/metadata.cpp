// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/metadata.h"

#include "codec/range_json.h"

namespace qmesh {

std::string metadataJson(const Availability& availability, TileId tile, int levels) {
  std::string text = R"({"available":[)";
  for (int zoom = tile.z + 1; zoom <= tile.z + levels; ++zoom) {
    text += zoom > tile.z + 1 ? "," : "";
    text +=
        zoom <= availability.maxZoom() ? rangesJson(availability.rangesUnder(tile, zoom)) : "[]";
  }
  return text + "]}";
}

} // namespace qmesh
