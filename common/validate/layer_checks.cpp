// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cmath>

#include "codec/json_reading.h"
#include "validate/tileset_checks.h"

namespace qmesh {

namespace {

using Json = nlohmann::json;
using json_reading::member;

/// Looks at the keys of one layer.json and mends them as it goes.
class LayerCheck {
 public:
  LayerCheck(Json& doc, Findings& findings) : doc_(doc), findings_(findings) {}

  void run() {
    checkFormat();
    checkTiles();
    checkProjection();
    checkScheme();
    checkAvailable();
    checkMetadata();
    checkBounds();
    checkWords();
  }

 private:
  void add(int code, const std::string& what) { findings_.push_back({code, "layer.json", what}); }
  std::string textOf(const char* key) const;
  void checkFormat();
  void checkTiles();
  void checkProjection();
  void checkScheme();
  void checkAvailable();
  void checkMetadata();
  void checkBounds();
  void checkWords();

  Json& doc_;
  Findings& findings_;
};

std::string LayerCheck::textOf(const char* key) const {
  const Json& value = member(doc_, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

void LayerCheck::checkFormat() {
  const std::string format = textOf("format");
  if (format.rfind("quantized-mesh-1.", 0) == 0)
    return;
  add(103, format.empty() ? "the key is missing" : "it is \"" + format + "\"");
  doc_["format"] = "quantized-mesh-1.0";
}

void LayerCheck::checkTiles() {
  const Json& tiles = member(doc_, "tiles");
  const bool found = tiles.is_array() && std::any_of(tiles.begin(), tiles.end(),
                                                     [](const Json& t) { return t.is_string(); });
  if (!found) {
    add(104, tiles.is_string() ? "it is a text, not a list" : "the key is missing or empty");
    doc_["tiles"] = Json::array(
        {tiles.is_string() ? tiles.get<std::string>() : std::string("{z}/{x}/{y}.terrain")});
  }
  for (Json& pattern : doc_["tiles"]) {
    if (!pattern.is_string())
      continue;
    const auto text = pattern.get<std::string>();
    const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
    const std::size_t before = findings_.size();
    if (!has("{z}") || !has("{x}") || !(has("{y}") || has("{reverseY}")))
      add(117, "\"" + text + "\"");
    if (findings_.size() > before)
      pattern = "{z}/{x}/{y}.terrain";
    if (has("{version}") && member(doc_, "version").is_null())
      add(116, "\"" + text + "\"");
  }
}

void LayerCheck::checkProjection() {
  const Json& value = member(doc_, "projection");
  const std::string text = textOf("projection");
  if (value.is_null() || text == "EPSG:4326" || text == "EPSG:3857")
    return;
  add(105, "it is " + value.dump());
  const bool mercator = text.find("3857") != std::string::npos ||
                        text.find("900913") != std::string::npos ||
                        text.find("ercator") != std::string::npos;
  doc_["projection"] = mercator ? "EPSG:3857" : "EPSG:4326";
}

void LayerCheck::checkScheme() {
  const Json& value = member(doc_, "scheme");
  const bool fromNorth = textOf("scheme") == "xyz";
  if (!value.is_null() && textOf("scheme") != "tms" && textOf("scheme") != "slippyMap") {
    add(106, "it is " + value.dump());
    doc_["scheme"] = fromNorth ? "slippyMap" : "tms";
  }
  if (value.is_null() && !member(doc_, "schema").is_null())
    add(107, "it is " + member(doc_, "schema").dump());
}

void LayerCheck::checkAvailable() {
  const Json& levels = member(doc_, "available");
  if (levels.is_null() || (levels.is_array() && levels.empty())) {
    if (member(doc_, "metadataAvailability").is_null())
      add(108, levels.is_null() ? "both keys are missing" : "\"available\" is empty");
    doc_.erase("available");
    return;
  }
  if (!levels.is_array()) {
    add(109, "it is no list");
    doc_.erase("available");
    return;
  }
  const Scheme scheme(textOf("projection") == "EPSG:3857" ? Profile::mercator : Profile::geodetic);
  if (levels.size() > std::size_t(kMaxZoom) + 1) {
    add(109, "it has " + std::to_string(levels.size()) + " levels; " +
                 std::to_string(kMaxZoom + 1) + " are read");
    doc_["available"].erase(doc_["available"].begin() + kMaxZoom + 1, doc_["available"].end());
  }
  for (std::size_t zoom = 0; zoom < doc_["available"].size(); ++zoom) {
    Json& level = doc_["available"][zoom];
    std::vector<std::vector<TileRange>> read;
    const Json alone = Json::array({level});
    const Status status = json_reading::readLevels("\"available\"", alone, scheme, int(zoom), read);
    std::uint64_t tiles = 0;
    for (const auto& ranges : read)
      for (const TileRange& range : ranges)
        tiles += range.count();
    if (!status.ok()) {
      add(109, "zoom " + std::to_string(zoom) + ": " + status.message());
      level = Json::array();
      continue;
    }
    const auto listed = ListedTiles::of(read);
    if (listed.ok() && listed->count(0) != tiles)
      add(110, "zoom " + std::to_string(zoom) + ": " + std::to_string(tiles - listed->count(0)) +
                   " tiles");
  }
}

void LayerCheck::checkMetadata() {
  const Json& value = member(doc_, "metadataAvailability");
  const double number = json_reading::numberOf(value, -1);
  if (value.is_null() || (number >= 1 && number <= kMaxZoom && std::floor(number) == number))
    return;
  add(122, "it is " + value.dump());
  doc_.erase("metadataAvailability");
}

void LayerCheck::checkBounds() {
  const Json& box = member(doc_, "bounds");
  double edges[4] = {};
  bool good = box.is_array() && box.size() == 4;
  for (std::size_t k = 0; good && k < 4; ++k) {
    edges[k] = json_reading::numberOf(box[k], std::nan(""));
    good = std::isfinite(edges[k]);
  }
  good = good && edges[0] >= -180 && edges[2] <= 180 && edges[0] < edges[2] && edges[1] >= -90 &&
         edges[3] <= 90 && edges[1] < edges[3];
  if (good)
    return;
  add(118, box.is_null() ? "the key is missing" : "they are " + box.dump());
  doc_.erase("bounds");
}

void LayerCheck::checkWords() {
  const Json& words = member(doc_, "extensions");
  for (const Json& word : words.is_array() ? words : Json::array()) {
    const std::string text = word.is_string() ? word.get<std::string>() : word.dump();
    if (text == "vertexnormals")
      add(121, "");
    else if (text != "octvertexnormals" && text != "watermask" && text != "metadata")
      add(120, "\"" + text + "\"");
  }
  if (textOf("attribution").empty())
    add(123, "");
}

} // namespace

CheckedLayer checkLayer(const std::string& text, Findings& findings) {
  CheckedLayer checked;
  Result<Json> doc = json_reading::parseObject("layer.json", text);
  if (!doc.ok()) {
    if (text.empty())
      findings.push_back({101, "layer.json", ""});
    else
      findings.push_back({102, "layer.json", doc.status().message()});
    return checked;
  }
  LayerCheck(*doc, findings).run();
  Result<LayerJson> layer =
      readLayerJson(doc->dump(-1, ' ', false, Json::error_handler_t::replace));
  if (layer.ok())
    checked.layer = *std::move(layer);
  else
    findings.push_back({102, "layer.json", layer.status().message()});
  checked.available = !checked.layer.available.empty();
  const Json& maxZoom = member(*doc, "maxzoom");
  const Json& minZoom = member(*doc, "minzoom");
  if (checked.available && !maxZoom.is_null() &&
      checked.layer.maxZoom < int(checked.layer.available.size()) - 1)
    findings.push_back({113, "layer.json",
                        "it is " + maxZoom.dump() + ", the deepest level is " +
                            std::to_string(checked.layer.available.size() - 1)});
  if (checked.available && checked.layer.metadataAvailability == 0 &&
      checked.layer.maxZoom > int(checked.layer.available.size()) - 1)
    findings.push_back({114, "layer.json",
                        "it is " + maxZoom.dump() + ", the deepest level is " +
                            std::to_string(checked.layer.available.size() - 1)});
  int first = 0;
  while (checked.available && std::size_t(first) + 1 < checked.layer.available.size() &&
         checked.layer.available[std::size_t(first)].empty())
    ++first;
  if (checked.available && !minZoom.is_null() && checked.layer.minZoom != first)
    findings.push_back(
        {115, "layer.json",
         "it is " + minZoom.dump() + ", the first level is " + std::to_string(first)});
  return checked;
}

} // namespace qmesh
