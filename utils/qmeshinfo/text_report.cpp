// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "base/text.h"
#include "info_report.h"

namespace qmesh {

namespace {

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  const bool zero = std::strspn(text, "-0.") == std::strlen(text);
  return zero && text[0] == '-' ? text + 1 : text;
}

std::string boxText(const GeoBox& box) {
  std::vector<std::string> numbers;
  for (const double number : {box.west, box.south, box.east, box.north})
    numbers.push_back(formatNumber(std::round(number * 1e9) / 1e9));
  return join(numbers, " ");
}

/// Lines of columns, each as wide as its widest word, numbers to the right.
std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k == widths.size())
        widths.push_back(0);
      widths[k] = std::max(widths[k], row[k].size());
    }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k)
      text += std::string(widths[k] - row[k].size() + 2, ' ') + row[k];
    text += "\n";
  }
  return text;
}

void addLine(std::string& text, const char* name, const std::string& value) {
  if (!value.empty())
    text += std::string(name) + ": " + value + "\n";
}

std::string whole(std::uint64_t number) {
  return std::to_string(number);
}

const LayerJson::Level* recordOf(const LayerJson& layer, int zoom) {
  for (const LayerJson::Level& level : layer.levels)
    if (level.zoom == zoom)
      return &level;
  return nullptr;
}

std::string layerText(const InfoReport& report) {
  const Tileset& set = *report.set;
  const LayerJson& layer = set.layer();
  std::string text = "Terrain: " + report.path + "\n";
  addLine(text, "Name", layer.name);
  addLine(text, "Description", layer.description);
  addLine(text, "Attribution", layer.attribution);
  addLine(text, "Version", layer.version);
  addLine(text, "Format", layer.format);
  addLine(text, "Projection",
          std::string(set.scheme().crs()) +
              (layer.profile == Profile::geodetic ? ", two root tiles" : ", one root tile"));
  addLine(text, "Scheme",
          layer.slippyMap ? "slippyMap, rows from the north" : "tms, rows from the south");
  addLine(text, "Tiles", join(layer.tiles, " "));
  addLine(text, "Bounds", boxText(layer.bounds));
  addLine(text, "Extensions", layer.extensions.empty() ? "none" : join(layer.extensions, ", "));
  if (layer.metadataAvailability > 0)
    addLine(text, "Metadata", "every " + std::to_string(layer.metadataAvailability) + " zooms");
  addLine(text, "Parent", layer.parentUrl);
  addLine(text, "Made by", layer.generator);
  addLine(text, "Method", layer.method);
  if (layer.cellsPerTile > 0)
    addLine(text, "Cells per tile edge", std::to_string(layer.cellsPerTile));
  if (!layer.method.empty())
    addLine(text, "Extent of the data", boxText(layer.extent));
  return text;
}

std::string levelsText(const InfoReport& report) {
  const Tileset& set = *report.set;
  std::vector<std::vector<std::string>> rows = {
      {"zoom", "tiles", "columns", "rows", "west south east north", "max error m", "reached m"}};
  std::uint64_t tiles = 0;
  for (int zoom = 0; zoom <= set.available().maxZoom(); ++zoom) {
    const auto bounds = set.available().bounds(zoom);
    const std::uint64_t count = set.available().count(zoom);
    tiles += count;
    if (!bounds) {
      rows.push_back({std::to_string(zoom), "0", "-", "-", "-", "-", "-"});
      continue;
    }
    const GeoBox low = set.scheme().box({zoom, bounds->x0, bounds->y0});
    const GeoBox high = set.scheme().box({zoom, bounds->x1, bounds->y1});
    const LayerJson::Level* record = recordOf(set.layer(), zoom);
    rows.push_back({std::to_string(zoom), whole(count), whole(bounds->x0) + "-" + whole(bounds->x1),
                    whole(bounds->y0) + "-" + whole(bounds->y1),
                    boxText({low.west, low.south, high.east, high.north}),
                    record ? fixed(record->maxError, 3) : "-",
                    record ? fixed(record->errorReached, 3) : "-"});
  }
  return "Listed: " + whole(tiles) + " tiles\n" + table(rows);
}

std::string surveyText(const Survey& survey) {
  std::vector<std::vector<std::string>> rows = {{"zoom", "tiles", "bytes", "triangles", "vertices",
                                                 "lowest m", "highest m", "normals", "water masks",
                                                 "metadata", "gzip"}};
  SurveyLevel sum;
  const auto row = [&](const std::string& name, const SurveyLevel& level) {
    const bool any = level.tiles > 0;
    rows.push_back({name, whole(level.tiles), whole(level.bytes), whole(level.triangles),
                    whole(level.vertices), any ? fixed(level.lowest, 3) : "-",
                    any ? fixed(level.highest, 3) : "-", whole(level.normals),
                    whole(level.waterMasks), whole(level.metadata), whole(level.compressed)});
  };
  for (const SurveyLevel& level : survey.levels) {
    row(std::to_string(level.zoom), level);
    sum.lowest = sum.tiles == 0 ? level.lowest : std::min(sum.lowest, level.lowest);
    sum.highest = sum.tiles == 0 ? level.highest : std::max(sum.highest, level.highest);
    sum.tiles += level.tiles;
    sum.bytes += level.bytes;
    sum.triangles += level.triangles;
    sum.vertices += level.vertices;
    sum.normals += level.normals;
    sum.waterMasks += level.waterMasks;
    sum.metadata += level.metadata;
    sum.compressed += level.compressed;
  }
  row("all", sum);
  return "Read: " + whole(survey.tiles) + " tiles\n" + table(rows);
}

std::string vectorText(const Vec3& v) {
  return formatNumber(v.x) + " " + formatNumber(v.y) + " " + formatNumber(v.z);
}

std::string tileText(const TileReport& tile) {
  const TileMesh& mesh = *tile.read.mesh;
  const TileHeader& header = mesh.header;
  std::string text = "Tile: " + tileName(tile.tile) + "\n";
  addLine(text, "File", tile.path);
  addLine(text, "Box", boxText(tile.box));
  addLine(text, "Bytes",
          whole(tile.storedBytes) +
              (tile.read.compressed ? " (gzip; " + whole(tile.read.size) + " unpacked)" : ""));
  addLine(text, "Triangles", whole(mesh.triangleCount()));
  addLine(text, "Vertices", whole(mesh.vertexCount()));
  addLine(text, "Edge vertices",
          "west " + whole(mesh.edges[0].size()) + ", south " + whole(mesh.edges[1].size()) +
              ", east " + whole(mesh.edges[2].size()) + ", north " + whole(mesh.edges[3].size()));
  addLine(text, "Centre", vectorText(header.centre));
  addLine(text, "Header heights",
          fixed(double(header.minHeight), 3) + " to " + fixed(double(header.maxHeight), 3) + " m");
  addLine(text, "Vertex heights", fixed(tile.lowest, 3) + " to " + fixed(tile.highest, 3) + " m");
  addLine(text, "Bounding sphere",
          vectorText(header.sphere.centre) + ", radius " + fixed(header.sphere.radius, 3) + " m");
  addLine(text, "Horizon point", vectorText(header.horizon));
  std::vector<std::string> extensions;
  for (const int id : tile.read.extensions)
    extensions.push_back(id == 1   ? "octvertexnormals"
                         : id == 2 ? "watermask"
                         : id == 4 ? "metadata"
                                   : "unknown " + std::to_string(id));
  addLine(text, "Extensions", extensions.empty() ? "none" : join(extensions, ", "));
  if (mesh.extensions.waterMask.size() == 1)
    addLine(text, "Water mask", mesh.extensions.waterMask[0] ? "all water" : "all land");
  addLine(text, "Metadata", mesh.extensions.metadata);
  for (const Finding& finding : tile.findings)
    text += codeText(finding.code) + " " + enumName(findingKind(finding.code).severity) + ": " +
            findingKind(finding.code).title + (finding.what.empty() ? "" : ": " + finding.what) +
            "\n";
  return text;
}

std::string validationText(const Survey& survey, const FindingCounts& book) {
  std::string text;
  for (const auto& [code, entry] : book.entries()) {
    const FindingKind& kind = findingKind(code);
    text += codeText(code) + " " + enumName(kind.severity) + ": " + kind.title + " (" +
            whole(entry.count) + (entry.count == 1 ? " place)\n" : " places)\n");
    text += "  " + std::string(kind.explanation) + "\n  Cure: " + kind.cure + "\n";
    for (const Finding& finding : entry.first)
      text += "    " + finding.place + (finding.what.empty() ? "" : ": " + finding.what) + "\n";
    if (entry.count > entry.first.size())
      text += "    ... and " + whole(entry.count - entry.first.size()) + " more\n";
  }
  text += "Validated: " + whole(survey.tiles) + " tiles, " + whole(survey.seams.seams) +
          " seams, largest gap " + fixed(survey.seams.largestGap, 4) + " m\n";
  return text + "Result: " + whole(book.count(Severity::error)) + " errors, " +
         whole(book.count(Severity::warning)) + " warnings, " + whole(book.count(Severity::note)) +
         " notes\n";
}

std::string demText(const DemReport& dem) {
  std::string text = "Error against " + dem.file + ": " + whole(dem.cells) + " cells" +
                     (dem.step > 1 ? " (every " + std::to_string(dem.step) +
                                         "th column and row; --dem-step 1 takes all)"
                                   : "") +
                     ", " + whole(dem.voids) + " of them void\n";
  std::vector<std::vector<std::string>> rows = {
      {"zoom", "cells", "uncovered", "max m", "rms m", "mean m", "99 % m", "largest at"}};
  for (const LevelError& level : dem.levels) {
    const bool any = level.cells > 0;
    const auto number = [&](double value) { return any ? fixed(value, 3) : std::string("-"); };
    rows.push_back({std::to_string(level.zoom), whole(level.cells), whole(level.uncovered),
                    number(level.max), number(level.rms), number(level.mean), number(level.p99),
                    any ? fixed(level.maxLon, 6) + "," + fixed(level.maxLat, 6) : "-"});
  }
  return text + table(rows);
}

std::string samplesText(const std::vector<Sample>& samples) {
  std::string text;
  for (const Sample& sample : samples) {
    text += formatNumber(sample.lon) + " " + formatNumber(sample.lat) + " ";
    text += sample.height ? fixed(*sample.height, 3) + " " + tileName(sample.tile) : "- -";
    text += "\n";
  }
  return text;
}

} // namespace

std::string infoText(const InfoReport& report) {
  std::vector<std::string> parts;
  if (report.describe)
    parts.push_back(layerText(report) + levelsText(report));
  if (report.tile)
    parts.push_back(tileText(*report.tile));
  if (report.survey && !report.set->singleTile())
    parts.push_back(surveyText(*report.survey));
  if (report.book)
    parts.push_back(validationText(*report.survey, *report.book));
  if (report.dem)
    parts.push_back(demText(*report.dem));
  if (report.samples)
    parts.push_back(samplesText(*report.samples));
  return join(parts, "\n");
}

std::string findingsText() {
  std::string text;
  FindingGroup group{};
  for (const FindingKind& kind : findingKinds()) {
    if (kind.group() != group)
      for (const EnumRow<FindingGroup>& row : EnumTable<FindingGroup>::kRows)
        if (row.value == kind.group())
          text += (text.empty() ? "" : "\n") + std::string(row.name) + ": " + row.help + "\n";
    group = kind.group();
    text += "  " + codeText(kind.code) + " " + enumName(kind.severity) + ": " + kind.title +
            "\n    " + kind.explanation + "\n    Cure: " + kind.cure + "\n";
  }
  return text;
}

} // namespace qmesh
