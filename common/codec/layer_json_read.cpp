// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "codec/layer_json.h"

namespace qmesh {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxText = std::size_t(256) << 20; ///< bytes
constexpr int kMaxDepth = 64;
constexpr int kMaxLevels = kMaxZoom + 1;

Status fault(const std::string& what) {
  return {Code::input, "layer.json cannot be used: " + what + "."};
}

/// The member, or a null value where `object` has none.
const Json& member(const Json& object, const char* key) {
  static const Json kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

/// Text, also where a producer wrote a number without quotes (as "version" often is).
std::string textOf(const Json& object, const char* key) {
  const Json& value = member(object, key);
  if (value.is_string())
    return value.get<std::string>();
  return value.is_number() ? value.dump() : std::string();
}

double numberOf(const Json& value, double fallback) {
  if (!value.is_number())
    return fallback;
  const double number = value.get<double>();
  return std::isfinite(number) ? number : fallback;
}

/// A whole number in first..last, or `fallback`.
int integerOf(const Json& object, const char* key, int last, int fallback) {
  const double number = numberOf(member(object, key), -1);
  return number >= 0 && number <= last && std::floor(number) == number ? int(number) : fallback;
}

/// The texts of a list, other things in it passed over; none where there is no list.
std::vector<std::string> textsOf(const Json& object, const char* key) {
  std::vector<std::string> texts;
  const Json& list = member(object, key);
  if (list.is_array())
    for (const Json& value : list)
      if (value.is_string())
        texts.push_back(value.get<std::string>());
  return texts;
}

Status readFormat(const Json& doc, LayerJson& layer) {
  layer.format = textOf(doc, "format");
  if (layer.format.empty())
    return fault("it does not say which format the tiles have");
  if (layer.format.rfind("quantized-mesh-1.", 0) != 0)
    return fault("the tiles have the format \"" + layer.format + "\", not quantized-mesh-1.0");
  layer.tiles = textsOf(doc, "tiles");
  if (layer.tiles.empty())
    return fault("it has no \"tiles\", the pattern of the tiles' addresses");
  return {};
}

Status readScheme(const Json& doc, LayerJson& layer) {
  const std::string projection = textOf(doc, "projection");
  if (projection.empty() || projection == "EPSG:4326")
    layer.profile = Profile::geodetic;
  else if (projection == "EPSG:3857")
    layer.profile = Profile::mercator;
  else
    return fault("the projection \"" + projection + "\" is neither EPSG:4326 nor EPSG:3857");

  const std::string scheme = textOf(doc, "scheme");
  layer.slippyMap = scheme == "slippyMap";
  if (!layer.slippyMap && !scheme.empty() && scheme != "tms")
    return fault("the scheme \"" + scheme + "\" is neither tms nor slippyMap");
  return {};
}

/// A coordinate of a range: a whole number below `end`.
bool readCoordinate(const Json& range, const char* key, std::uint32_t end, std::uint32_t& to) {
  const double number = numberOf(member(range, key), -1);
  if (number < 0 || number >= end || std::floor(number) != number)
    return false;
  to = std::uint32_t(number);
  return true;
}

Status readRange(const Json& json, const Scheme& scheme, int zoom, std::vector<TileRange>& ranges) {
  TileRange range;
  const std::uint32_t columns = scheme.tilesX(zoom);
  const std::uint32_t rows = scheme.tilesY(zoom);
  if (!json.is_object() || !readCoordinate(json, "startX", columns, range.x0) ||
      !readCoordinate(json, "startY", rows, range.y0) ||
      !readCoordinate(json, "endX", columns, range.x1) ||
      !readCoordinate(json, "endY", rows, range.y1) || range.x0 > range.x1 || range.y0 > range.y1)
    return fault("a range under \"available\" is not one of tiles of zoom " + std::to_string(zoom));
  ranges.push_back(range);
  return {};
}

Status readAvailable(const Json& doc, LayerJson& layer) {
  const Json& levels = member(doc, "available");
  if (levels.is_null())
    return {};
  if (!levels.is_array())
    return fault("\"available\" is not a list");
  if (levels.size() > kMaxLevels)
    return fault("\"available\" goes deeper than zoom " + std::to_string(kMaxZoom));
  const Scheme scheme(layer.profile);
  layer.available.resize(levels.size());
  for (std::size_t zoom = 0; zoom < levels.size(); ++zoom) {
    if (!levels[zoom].is_array())
      return fault("\"available\" has no list for zoom " + std::to_string(zoom));
    for (const Json& range : levels[zoom])
      QMESH_RETURN_IF_ERROR(readRange(range, scheme, int(zoom), layer.available[zoom]));
  }
  return {};
}

void readBox(const Json& doc, const char* key, GeoBox& box) {
  const Json& list = member(doc, key);
  if (!list.is_array() || list.size() != 4)
    return;
  double values[4];
  for (std::size_t i = 0; i < 4; ++i) {
    values[i] = numberOf(list[i], std::numeric_limits<double>::quiet_NaN());
    if (std::isnan(values[i]))
      return;
  }
  box = {values[0], values[1], values[2], values[3]};
}

/// What we wrote ourselves under "qmesh".
void readRecord(const Json& doc, LayerJson& layer) {
  const Json& record = member(doc, "qmesh");
  if (!record.is_object())
    return;
  layer.generator = textOf(record, "generator");
  layer.method = textOf(record, "method");
  layer.cellsPerTile = integerOf(record, "cellsPerTile", 1024, 0);
  readBox(record, "extent", layer.extent);
  const Json& levels = member(record, "levels");
  if (!levels.is_array())
    return;
  for (const Json& level : levels)
    if (level.is_object())
      layer.levels.push_back({integerOf(level, "zoom", kMaxZoom, 0),
                              numberOf(member(level, "maxError"), 0),
                              numberOf(member(level, "errorReached"), 0)});
}

/// The JSON of `text`, or a null value and what is wrong.
Result<Json> parse(const std::string& text) {
  if (text.size() > kMaxText)
    return fault("it is larger than 256 MB");
  bool tooDeep = false;
  const auto isKept = [&](int depth, Json::parse_event_t event, const Json&) {
    const bool opens =
        event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    tooDeep = tooDeep || (opens && depth >= kMaxDepth); // depth counts what is open already
    return !tooDeep;
  };
  Json doc = Json::parse(text, isKept, /*allow_exceptions=*/false);
  if (tooDeep)
    return fault("it is nested deeper than 64");
  if (doc.is_discarded())
    return fault("it is not JSON");
  if (!doc.is_object())
    return fault("it is not a JSON object");
  return doc;
}

} // namespace

Result<LayerJson> readLayerJson(const std::string& text) {
  const Result<Json> parsed = parse(text);
  if (!parsed.ok())
    return parsed.status();
  const Json& doc = *parsed;
  LayerJson layer;
  QMESH_RETURN_IF_ERROR(readFormat(doc, layer));
  QMESH_RETURN_IF_ERROR(readScheme(doc, layer));
  QMESH_RETURN_IF_ERROR(readAvailable(doc, layer));
  layer.name = textOf(doc, "name");
  layer.description = textOf(doc, "description");
  layer.version = textOf(doc, "version");
  layer.attribution = textOf(doc, "attribution");
  layer.parentUrl = textOf(doc, "parentUrl");
  layer.extensions = textsOf(doc, "extensions");
  const int deepestListed = layer.available.empty() ? 0 : int(layer.available.size()) - 1;
  layer.minZoom = integerOf(doc, "minzoom", kMaxZoom, 0);
  layer.maxZoom = integerOf(doc, "maxzoom", kMaxZoom, deepestListed);
  layer.metadataAvailability = integerOf(doc, "metadataAvailability", kMaxZoom, 0);
  readBox(doc, "bounds", layer.bounds);
  readRecord(doc, layer);
  return layer;
}

} // namespace qmesh
