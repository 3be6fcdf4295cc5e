// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "codec/json_reading.h"
#include "codec/layer_json.h"

namespace qmesh {
namespace {

using Json = nlohmann::json;
using json_reading::member;
using json_reading::numberOf;

constexpr char kSubject[] = "layer.json";

Status fault(const std::string& what) {
  return json_reading::fault(kSubject, what);
}

/// Text, also where a producer wrote a number without quotes (as "version" often is).
std::string textOf(const Json& object, const char* key) {
  const Json& value = member(object, key);
  if (value.is_string())
    return value.get<std::string>();
  return value.is_number() ? value.dump() : std::string();
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

} // namespace

Result<LayerJson> readLayerJson(const std::string& text) {
  const Result<Json> parsed = json_reading::parseObject(kSubject, text);
  if (!parsed.ok())
    return parsed.status();
  const Json& doc = *parsed;
  LayerJson layer;
  QMESH_RETURN_IF_ERROR(readFormat(doc, layer));
  QMESH_RETURN_IF_ERROR(readScheme(doc, layer));
  QMESH_RETURN_IF_ERROR(json_reading::readLevels(kSubject, member(doc, "available"),
                                                 Scheme(layer.profile), 0, layer.available));
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
