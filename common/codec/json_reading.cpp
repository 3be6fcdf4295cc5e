// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/json_reading.h"

#include <cmath>

namespace qmesh::json_reading {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxText = std::size_t(256) << 20; ///< bytes
constexpr int kMaxDepth = 64;

/// A coordinate of a range: a whole number below `end`.
bool readCoordinate(const Json& range, const char* key, std::uint32_t end, std::uint32_t& to) {
  const double number = numberOf(member(range, key), -1);
  if (number < 0 || number >= end || std::floor(number) != number)
    return false;
  to = std::uint32_t(number);
  return true;
}

bool readRange(const Json& json, const Scheme& scheme, int zoom, std::vector<TileRange>& ranges) {
  TileRange range;
  const std::uint32_t columns = scheme.tilesX(zoom);
  const std::uint32_t rows = scheme.tilesY(zoom);
  if (!json.is_object() || !readCoordinate(json, "startX", columns, range.x0) ||
      !readCoordinate(json, "startY", rows, range.y0) ||
      !readCoordinate(json, "endX", columns, range.x1) ||
      !readCoordinate(json, "endY", rows, range.y1) || range.x0 > range.x1 || range.y0 > range.y1)
    return false;
  ranges.push_back(range);
  return true;
}

} // namespace

Status fault(const std::string& subject, const std::string& what) {
  return {Code::input, subject + " cannot be used: " + what + "."};
}

Result<Json> parseObject(const std::string& subject, const std::string& text) {
  if (text.size() > kMaxText)
    return fault(subject, "it is larger than 256 MB");
  bool tooDeep = false;
  const auto isKept = [&](int depth, Json::parse_event_t event, const Json&) {
    const bool opens =
        event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    tooDeep = tooDeep || (opens && depth >= kMaxDepth); // depth counts what is open already
    return !tooDeep;
  };
  Json doc = Json::parse(text, isKept, /*allow_exceptions=*/false);
  if (tooDeep)
    return fault(subject, "it is nested deeper than 64");
  if (doc.is_discarded())
    return fault(subject, "it is not JSON");
  if (!doc.is_object())
    return fault(subject, "it is not a JSON object");
  return doc;
}

const Json& member(const Json& object, const char* key) {
  static const Json kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

double numberOf(const Json& value, double fallback) {
  if (!value.is_number())
    return fallback;
  const double number = value.get<double>();
  return std::isfinite(number) ? number : fallback;
}

Status readLevels(const std::string& subject, const Json& levels, const Scheme& scheme,
                  int firstZoom, std::vector<std::vector<TileRange>>& to) {
  if (levels.is_null())
    return {};
  if (!levels.is_array())
    return fault(subject, "\"available\" is not a list");
  if (levels.size() > std::size_t(kMaxZoom + 1 - firstZoom))
    return fault(subject, "\"available\" goes deeper than zoom " + std::to_string(kMaxZoom));
  to.resize(levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const int zoom = firstZoom + int(k);
    if (!levels[k].is_array())
      return fault(subject, "\"available\" has no list for zoom " + std::to_string(zoom));
    for (const Json& range : levels[k])
      if (!readRange(range, scheme, zoom, to[k]))
        return fault(subject, "a range under \"available\" is not one of tiles of zoom " +
                                  std::to_string(zoom));
  }
  return {};
}

} // namespace qmesh::json_reading
