// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/range_json.h"

namespace qmesh {

std::string rangesJson(const std::vector<TileRange>& ranges, const std::string& gap,
                       const std::string& end) {
  std::string text = "[";
  for (const TileRange& range : ranges) {
    text += (text.size() > 1 ? "," : "") + gap;
    text += R"({"startX":)" + std::to_string(range.x0) + R"(,"startY":)" +
            std::to_string(range.y0) + R"(,"endX":)" + std::to_string(range.x1) + R"(,"endY":)" +
            std::to_string(range.y1) + "}";
  }
  return text + (ranges.empty() ? "" : end) + "]";
}

} // namespace qmesh
