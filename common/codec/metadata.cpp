// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/metadata.h"

#include "codec/json_reading.h"
#include "codec/range_json.h"

namespace qmesh {

std::string metadataJson(const std::vector<std::vector<TileRange>>& levels) {
  std::string text = R"({"available":[)";
  for (std::size_t k = 0; k < levels.size(); ++k)
    text += (k > 0 ? "," : "") + rangesJson(levels[k]);
  return text + "]}";
}

Result<std::vector<std::vector<TileRange>>> readMetadataJson(const std::string& text,
                                                             const Scheme& scheme, TileId tile) {
  const std::string subject = "The metadata of a tile";
  const Result<nlohmann::json> parsed = json_reading::parseObject(subject, text);
  if (!parsed.ok())
    return parsed.status();
  std::vector<std::vector<TileRange>> levels;
  QMESH_RETURN_IF_ERROR(json_reading::readLevels(
      subject, json_reading::member(*parsed, "available"), scheme, tile.z + 1, levels));
  return levels;
}

} // namespace qmesh
