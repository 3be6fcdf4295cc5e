// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>
#include <nlohmann/json.hpp>

#include "info_report.h"

namespace qmesh {

namespace {

using Json = nlohmann::ordered_json;

/// Numbers JSON has no words for become null.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json boxJson(const GeoBox& box) {
  return {box.west, box.south, box.east, box.north};
}

Json vectorJson(const Vec3& v) {
  return {number(v.x), number(v.y), number(v.z)};
}

Json layerJson(const LayerJson& layer, const Scheme& scheme) {
  Json out;
  const auto text = [&](const char* key, const std::string& value) {
    if (!value.empty())
      out[key] = value;
  };
  text("name", layer.name);
  text("description", layer.description);
  text("attribution", layer.attribution);
  text("version", layer.version);
  out["format"] = layer.format;
  out["projection"] = scheme.crs();
  out["scheme"] = layer.slippyMap ? "slippyMap" : "tms";
  out["tiles"] = layer.tiles;
  out["bounds"] = boxJson(layer.bounds);
  out["minzoom"] = layer.minZoom;
  out["maxzoom"] = layer.maxZoom;
  out["extensions"] = layer.extensions;
  if (layer.metadataAvailability > 0)
    out["metadataAvailability"] = layer.metadataAvailability;
  text("parentUrl", layer.parentUrl);
  text("generator", layer.generator);
  text("method", layer.method);
  if (layer.cellsPerTile > 0)
    out["cellsPerTile"] = layer.cellsPerTile;
  if (!layer.method.empty())
    out["extent"] = boxJson(layer.extent);
  return out;
}

Json levelsJson(const Tileset& set) {
  Json levels = Json::array();
  for (int zoom = 0; zoom <= set.available().maxZoom(); ++zoom) {
    Json level = {{"zoom", zoom}, {"tiles", set.available().count(zoom)}};
    if (const auto bounds = set.available().bounds(zoom)) {
      const GeoBox low = set.scheme().box({zoom, bounds->x0, bounds->y0});
      const GeoBox high = set.scheme().box({zoom, bounds->x1, bounds->y1});
      level["columns"] = {bounds->x0, bounds->x1};
      level["rows"] = {bounds->y0, bounds->y1};
      level["box"] = boxJson({low.west, low.south, high.east, high.north});
    }
    for (const LayerJson::Level& record : set.layer().levels)
      if (record.zoom == zoom) {
        level["maxError"] = number(record.maxError);
        level["errorReached"] = number(record.errorReached);
      }
    levels.push_back(std::move(level));
  }
  return levels;
}

Json surveyJson(const Survey& survey) {
  Json levels = Json::array();
  for (const SurveyLevel& stats : survey.levels) {
    Json level = {{"zoom", stats.zoom},
                  {"tiles", stats.tiles},
                  {"bytes", stats.bytes},
                  {"triangles", stats.triangles},
                  {"vertices", stats.vertices},
                  {"normals", stats.normals},
                  {"waterMasks", stats.waterMasks},
                  {"metadata", stats.metadata},
                  {"compressed", stats.compressed}};
    if (stats.tiles > 0) {
      level["lowest"] = number(stats.lowest);
      level["highest"] = number(stats.highest);
    }
    levels.push_back(std::move(level));
  }
  return {{"tiles", survey.tiles}, {"levels", std::move(levels)}};
}

Json kindJson(const FindingKind& kind) {
  return {{"code", codeText(kind.code)},     {"severity", enumName(kind.severity)},
          {"group", enumName(kind.group())}, {"title", kind.title},
          {"explanation", kind.explanation}, {"cure", kind.cure}};
}

Json placeJson(const Finding& finding) {
  Json place = {{"place", finding.place}};
  if (!finding.what.empty())
    place["what"] = finding.what;
  return place;
}

Json validationJson(const Survey& survey, const FindingCounts& book) {
  Json findings = Json::array();
  for (const auto& [code, entry] : book.entries()) {
    Json finding = kindJson(findingKind(code));
    finding["count"] = entry.count;
    finding["places"] = Json::array();
    for (const Finding& one : entry.first)
      finding["places"].push_back(placeJson(one));
    findings.push_back(std::move(finding));
  }
  return {{"errors", book.count(Severity::error)}, {"warnings", book.count(Severity::warning)},
          {"notes", book.count(Severity::note)},   {"tiles", survey.tiles},
          {"seams", survey.seams.seams},           {"largestGap", number(survey.seams.largestGap)},
          {"findings", std::move(findings)}};
}

Json tileJson(const TileReport& tile) {
  const TileMesh& mesh = *tile.read.mesh;
  const TileHeader& header = mesh.header;
  Json out = {
      {"tile", tileName(tile.tile)},
      {"file", tile.path},
      {"box", boxJson(tile.box)},
      {"bytes", tile.storedBytes},
      {"compressed", tile.read.compressed},
      {"unpackedBytes", tile.read.size},
      {"triangles", mesh.triangleCount()},
      {"vertices", mesh.vertexCount()},
      {"edgeVertices",
       {mesh.edges[0].size(), mesh.edges[1].size(), mesh.edges[2].size(), mesh.edges[3].size()}},
      {"centre", vectorJson(header.centre)},
      {"minHeight", number(double(header.minHeight))},
      {"maxHeight", number(double(header.maxHeight))},
      {"lowest", number(tile.lowest)},
      {"highest", number(tile.highest)},
      {"sphere",
       {{"centre", vectorJson(header.sphere.centre)}, {"radius", number(header.sphere.radius)}}},
      {"horizon", vectorJson(header.horizon)},
      {"extensions", tile.read.extensions}};
  if (!mesh.extensions.metadata.empty())
    out["metadata"] = mesh.extensions.metadata;
  if (mesh.extensions.waterMask.size() == 1)
    out["water"] = mesh.extensions.waterMask[0] != 0;
  if (!tile.findings.empty()) {
    out["findings"] = Json::array();
    for (const Finding& finding : tile.findings) {
      Json one = kindJson(findingKind(finding.code));
      if (!finding.what.empty())
        one["what"] = finding.what;
      out["findings"].push_back(std::move(one));
    }
  }
  return out;
}

Json demJson(const DemReport& dem) {
  Json levels = Json::array();
  for (const LevelError& error : dem.levels) {
    Json level = {{"zoom", error.zoom}, {"cells", error.cells}, {"uncovered", error.uncovered}};
    if (error.cells > 0) {
      level["max"] = number(error.max);
      level["rms"] = number(error.rms);
      level["mean"] = number(error.mean);
      level["p99"] = number(error.p99);
      level["maxAt"] = {error.maxLon, error.maxLat};
    }
    levels.push_back(std::move(level));
  }
  return {{"file", dem.file},
          {"step", dem.step},
          {"cells", dem.cells},
          {"voids", dem.voids},
          {"levels", std::move(levels)}};
}

Json samplesJson(const std::vector<Sample>& samples) {
  Json out = Json::array();
  for (const Sample& sample : samples) {
    Json one = {{"lon", sample.lon}, {"lat", sample.lat}};
    one["height"] = sample.height ? number(*sample.height) : Json();
    if (sample.height)
      one["tile"] = tileName(sample.tile);
    out.push_back(std::move(one));
  }
  return out;
}

std::string textOf(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

std::string infoJson(const InfoReport& report) {
  const Tileset& set = *report.set;
  Json out = {{"program", "qmeshinfo"}, {"version", QMESH_VERSION}, {"set", report.path}};
  if (report.describe) {
    out["layer"] = layerJson(set.layer(), set.scheme());
    out["levels"] = levelsJson(set);
  }
  if (report.tile)
    out["tile"] = tileJson(*report.tile);
  if (report.survey)
    out["stats"] = surveyJson(*report.survey);
  if (report.book)
    out["validation"] = validationJson(*report.survey, *report.book);
  if (report.dem)
    out["dem"] = demJson(*report.dem);
  if (report.samples)
    out["samples"] = samplesJson(*report.samples);
  return textOf(out);
}

std::string findingsJson() {
  Json findings = Json::array();
  for (const FindingKind& kind : findingKinds())
    findings.push_back(kindJson(kind));
  return textOf({{"program", "qmeshinfo"}, {"version", QMESH_VERSION}, {"findings", findings}});
}

} // namespace qmesh
