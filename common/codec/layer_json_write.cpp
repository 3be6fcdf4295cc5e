// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>

#include "base/text.h"
#include "codec/layer_json.h"
#include "codec/range_json.h"

namespace qmesh {
namespace {

/// JSON has no word for what is not a number.
std::string numberJson(double value) {
  return std::isfinite(value) ? formatNumber(value) : "null";
}

std::string stringsJson(const std::vector<std::string>& strings) {
  std::vector<std::string> quoted;
  for (const std::string& s : strings)
    quoted.push_back(jsonString(s));
  return "[" + join(quoted, ", ") + "]";
}

/// Members of an object, one a line.
class ObjectWriter {
 public:
  explicit ObjectWriter(std::string indent) : indent_(std::move(indent)) {}

  void raw(const std::string& key, const std::string& json) {
    text_ += (text_.empty() ? "\n" : ",\n") + indent_ + "  \"" + key + "\": " + json;
  }
  void string(const std::string& key, const std::string& value) { raw(key, jsonString(value)); }
  void optional(const std::string& key, const std::string& value) {
    if (!value.empty())
      string(key, value);
  }
  void integer(const std::string& key, int value) { raw(key, std::to_string(value)); }

  std::string json() const { return "{" + text_ + "\n" + indent_ + "}"; }

 private:
  std::string indent_;
  std::string text_;
};

std::string boundsJson(const GeoBox& box) {
  return "[" + numberJson(box.west) + ", " + numberJson(box.south) + ", " + numberJson(box.east) +
         ", " + numberJson(box.north) + "]";
}

std::string availableJson(const std::vector<std::vector<TileRange>>& available) {
  std::vector<std::string> levels;
  for (const auto& ranges : available)
    levels.push_back("\n    " + rangesJson(ranges, "\n      ", "\n    "));
  return "[" + join(levels, ",") + (levels.empty() ? "]" : "\n  ]");
}

std::string levelsJson(const std::vector<LayerJson::Level>& levels) {
  std::vector<std::string> lines;
  for (const LayerJson::Level& level : levels)
    lines.push_back("\n      {\"zoom\": " + std::to_string(level.zoom) +
                    ", \"maxError\": " + numberJson(level.maxError) +
                    ", \"errorReached\": " + numberJson(level.errorReached) + "}");
  return "[" + join(lines, ",") + (lines.empty() ? "]" : "\n    ]");
}

std::string recordJson(const LayerJson& layer) {
  ObjectWriter out("  ");
  out.string("generator", layer.generator);
  out.string("method", layer.method);
  out.integer("cellsPerTile", layer.cellsPerTile);
  out.raw("extent", boundsJson(layer.extent));
  out.raw("levels", levelsJson(layer.levels));
  return out.json();
}

} // namespace

std::string writeLayerJson(const LayerJson& layer) {
  ObjectWriter out("");
  out.string("tilejson", "2.1.0");
  out.string("name", layer.name);
  out.string("description", layer.description);
  out.string("version", layer.version);
  out.string("format", layer.format);
  out.optional("attribution", layer.attribution);
  out.string("scheme", layer.slippyMap ? "slippyMap" : "tms");
  out.string("projection", Scheme(layer.profile).crs());
  out.raw("bounds", boundsJson(layer.bounds));
  out.integer("minzoom", layer.minZoom);
  out.integer("maxzoom", layer.maxZoom);
  out.raw("tiles", stringsJson(layer.tiles));
  out.optional("parentUrl", layer.parentUrl);
  if (!layer.extensions.empty())
    out.raw("extensions", stringsJson(layer.extensions));
  if (layer.metadataAvailability > 0)
    out.integer("metadataAvailability", layer.metadataAvailability);
  out.raw("available", availableJson(layer.available));
  if (!layer.method.empty())
    out.raw("qmesh", recordJson(layer));
  return out.json() + "\n";
}

} // namespace qmesh
