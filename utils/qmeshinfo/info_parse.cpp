// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>

#include "base/text.h"
#include "qmeshinfo/info_options.h"

namespace qmesh {

namespace {

/// A file's extension, lower or upper case, is one of `known`.
Status checkExtension(const std::string& file, const std::vector<std::string>& known,
                      const char* option) {
  for (const std::string& extension : known)
    if (file.size() > extension.size() &&
        equalIgnoringCase(std::string_view(file).substr(file.size() - extension.size()), extension))
      return {};
  return {Code::usage,
          std::string(option) + " " + file + ": the extension must be one of " + join(known, ", ")};
}

Status checkInfo(const InfoOptions& options) {
  if (options.set.empty())
    return {Code::usage, "TILESET is missing: a folder with a layer.json, or a tile"};
  const bool tileWork = !options.exportFile.empty() || !options.drawing.empty();
  const bool isTile = options.set.find(".terrain") != std::string::npos;
  if (tileWork && !options.tile && !isTile)
    return {Code::usage, "--export and --draw need --tile Z/X/Y, or a .terrain file as TILESET"};
  if (!options.exportFile.empty())
    QMESH_RETURN_IF_ERROR(checkExtension(options.exportFile, {".obj", ".ply", ".off"}, "--export"));
  if (!options.drawing.empty())
    QMESH_RETURN_IF_ERROR(checkExtension(options.drawing, {".svg", ".png"}, "--draw"));
  if (!options.errorRaster.empty() && options.dem.path.empty())
    return {Code::usage, "--error-raster needs --dem"};
  for (const std::string& text : options.samples)
    if (text != "-") {
      const auto place = parseLonLat(text);
      if (!place.ok())
        return {Code::usage, "--sample " + place.status().message()};
    }
  return {};
}

} // namespace

Result<std::array<double, 2>> parseLonLat(const std::string& text) {
  std::string blanks = text;
  for (char& c : blanks)
    if (c == ',' || c == '\t' || c == ';')
      c = ' ';
  std::vector<double> numbers;
  bool fine = true;
  for (const std::string_view piece : split(trimmed(blanks), ' ')) {
    if (piece.empty())
      continue;
    const std::optional<double> number = parseNumber(piece);
    fine = fine && number;
    numbers.push_back(number.value_or(0));
  }
  if (!fine || numbers.size() != 2 || !(std::abs(numbers[0]) <= 360) ||
      !(std::abs(numbers[1]) <= 90))
    return Status(Code::usage, text + ": expected LON,LAT in degrees, longitude -360 to 360, "
                                      "latitude -90 to 90");
  return std::array<double, 2>{numbers[0], numbers[1]};
}

Result<InfoCommandLine> parseInfoCommandLine(const OptionTable& table,
                                             const std::vector<std::string>& words) {
  Result<ParsedWords> parsed = parseWords(table, words);
  if (!parsed.ok())
    return parsed.status();
  InfoCommandLine line;
  line.request = parsed->request;
  QMESH_RETURN_IF_ERROR(applyAssignments(parsed->assignments, line.options));
  if (line.request != Request::run)
    return line;
  line.warnings = parsed->warnings;
  QMESH_RETURN_IF_ERROR(checkInfo(line.options));
  return line;
}

} // namespace qmesh
