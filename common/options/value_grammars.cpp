// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/value_grammars.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/machine.h"
#include "options/row_builder.h"

namespace qmesh {

namespace {

constexpr const char* kAllCpus = "ALL_CPUS";
constexpr const char* kAutomatic = "auto";
constexpr std::array<char, 4> kMemoryUnits = {'K', 'M', 'G', 'T'};

/// The largest budget taken, so that bytes fit every integer type used later.
constexpr double kMostMemory = 1ull << 60;

/// A zoom, -1 where `text` is none.
int zoomOf(std::string_view text) {
  const Result<std::int64_t> zoom = parseIntegerIn(std::string(text), 0, kMaxZoom);
  return zoom.ok() ? static_cast<int>(*zoom) : -1;
}

/// Takes "K", "KB" or "KiB" (M, G, T alike) or "B" off the end of `text`; returns the factor.
double takeMemoryUnit(std::string_view& text) {
  const auto endsWith = [&](std::string_view unit) {
    return text.size() >= unit.size() &&
           equalIgnoringCase(text.substr(text.size() - unit.size()), unit);
  };
  double factor = 1;
  for (const char letter : kMemoryUnits) {
    factor *= 1024;
    for (const char* tail : {"", "B", "iB"}) {
      const std::string unit = letter + std::string(tail);
      if (!endsWith(unit))
        continue;
      text = trimmed(text.substr(0, text.size() - unit.size()));
      return factor;
    }
  }
  if (endsWith("B"))
    text = trimmed(text.substr(0, text.size() - 1));
  return 1;
}

/// The finite numbers of a list with blanks or commas between; empty where a piece is none.
std::vector<double> finiteNumbers(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::vector<double> numbers;
  for (const std::string_view piece : split(text, ' ')) {
    if (trimmed(piece).empty())
      continue;
    const std::optional<double> number = parseNumber(trimmed(piece));
    if (!number || !std::isfinite(*number))
      return {};
    numbers.push_back(*number);
  }
  return numbers;
}

} // namespace

Status setZooms(std::optional<int>& minZoom, std::optional<int>& maxZoom, const std::string& text) {
  const std::size_t dash = text.find('-');
  const std::string_view whole = text;
  const int first = zoomOf(trimmed(whole.substr(0, dash)));
  const std::string_view rest =
      dash == std::string::npos ? whole.substr(0, dash) : whole.substr(dash + 1);
  const bool open = dash != std::string::npos && trimmed(rest).empty();
  const int last = open ? kMaxZoom : zoomOf(trimmed(rest));
  if (first < 0 || last < 0)
    return expected("MIN-MAX, MIN- or N, zooms from 0 to " + std::to_string(kMaxZoom));
  if (first > last)
    return expected("the smaller zoom first");
  minZoom = first;
  maxZoom = open ? std::nullopt : std::optional<int>(last);
  return {};
}

std::string zoomsText(const std::optional<int>& minZoom, const std::optional<int>& maxZoom) {
  if (!minZoom && !maxZoom)
    return {};
  return fieldText(minZoom.value_or(0)) + "-" + fieldText(maxZoom);
}

Status setMemory(RunOptions& options, const std::string& text) {
  std::string_view number = trimmed(text);
  const bool percent = !number.empty() && number.back() == '%';
  if (percent)
    number = trimmed(number.substr(0, number.size() - 1));
  const double factor =
      percent ? static_cast<double>(machineMemoryBytes()) / 100 : takeMemoryUnit(number);
  const std::optional<double> value = parseNumber(number);
  const double bytes = value.value_or(0) * factor;
  if (percent && factor == 0)
    return expected("bytes: this machine does not say how much memory it has");
  if (!(bytes >= 1 && bytes <= kMostMemory) || (percent && *value > 100))
    return expected("512MB, 2GB, 40% or a number of bytes");
  options.memoryBytes = static_cast<std::uint64_t>(bytes);
  return {};
}

std::string memoryText(const RunOptions& options) {
  std::uint64_t number = options.memoryBytes;
  std::string unit;
  for (const char letter : kMemoryUnits) {
    if (number == 0 || number % 1024 != 0)
      break;
    number /= 1024;
    unit = std::string(1, letter) + "B";
  }
  return std::to_string(number) + unit;
}

Status setThreads(RunOptions& options, const std::string& text) {
  constexpr int kMostThreads = 1024;
  const Result<std::int64_t> number = parseIntegerIn(text, 1, kMostThreads);
  if (!number.ok() && !equalIgnoringCase(text, kAllCpus))
    return Status(Code::usage, number.status().message() + ", or " + kAllCpus);
  options.threads = number.ok() ? static_cast<int>(*number) : 0;
  return {};
}

std::string threadsText(const RunOptions& options) {
  return options.threads == 0 ? kAllCpus : fieldText(options.threads);
}

Status setExtent(InputOptions& options, const std::string& text) {
  const std::vector<double> numbers = finiteNumbers(text);
  if (numbers.size() != 4)
    return expected("four numbers: XMIN YMIN XMAX YMAX");
  if (!(numbers[0] < numbers[2] && numbers[1] < numbers[3]))
    return expected("XMIN below XMAX and YMIN below YMAX");
  options.extent = {numbers[0], numbers[1], numbers[2], numbers[3]};
  return {};
}

std::string extentText(const InputOptions& options) {
  std::vector<std::string> numbers;
  if (options.extent)
    for (const double number : *options.extent)
      numbers.push_back(formatNumber(number));
  return join(numbers, " ");
}

Status setObserver(MethodOptions& options, const std::string& text) {
  const std::vector<double> numbers = finiteNumbers(text);
  if (numbers.size() < 2 || numbers.size() > 3 || std::abs(numbers[0]) > 180 ||
      std::abs(numbers[1]) > 90)
    return expected("LON,LAT or LON,LAT,HEIGHT in degrees and metres");
  options.observer = {numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0};
  return {};
}

std::string observerText(const MethodOptions& options) {
  std::vector<std::string> numbers;
  if (options.observer)
    for (const double number : *options.observer)
      numbers.push_back(formatNumber(number));
  return join(numbers, ",");
}

Status setVoidFill(HeightOptions& options, const std::string& text) {
  const std::string interpolate = enumName(VoidFill::interpolate);
  if (equalIgnoringCase(text, interpolate)) {
    options.voidFill = VoidFill::interpolate;
    return {};
  }
  const Result<double> height = parseNumberIn(text, kLowestHeight, kHighestHeight);
  if (!height.ok())
    return Status(Code::usage, height.status().message() + ", or " + interpolate);
  options.voidFill = VoidFill::value;
  options.voidValue = *height;
  return {};
}

std::string voidFillText(const HeightOptions& options) {
  return options.voidFill == VoidFill::interpolate ? enumName(options.voidFill)
                                                   : formatNumber(options.voidValue);
}

Status setTileSize(TilingOptions& options, const std::string& text) {
  const Result<std::int64_t> size = parseIntegerIn(text, kSmallestTile, kLargestTile);
  if (!size.ok() || (*size & (*size - 1)) != 0)
    return expected("a power of two from " + std::to_string(kSmallestTile) + " to " +
                    std::to_string(kLargestTile));
  options.tileSize = static_cast<int>(*size);
  return {};
}

std::string tileSizeText(const TilingOptions& options) {
  return fieldText(options.tileSize);
}

Status setBlockTiles(RunOptions& options, const std::string& text) {
  if (equalIgnoringCase(text, kAutomatic)) {
    options.blockTiles = 0;
    return {};
  }
  const std::optional<std::int64_t> tiles = parseInteger(text);
  if (!tiles || (*tiles != 2 && *tiles != 4 && *tiles != 8))
    return expected("auto, 2, 4 or 8");
  options.blockTiles = static_cast<int>(*tiles);
  return {};
}

std::string blockTilesText(const RunOptions& options) {
  return options.blockTiles == 0 ? kAutomatic : fieldText(options.blockTiles);
}

Status setNodata(InputOptions& options, const std::string& text) {
  const std::optional<double> value = parseNumber(text);
  if (!value)
    return expected("a number or nan");
  options.sourceNodata = *value;
  return {};
}

std::string nodataText(const InputOptions& options) {
  return fieldText(options.sourceNodata);
}

Result<TileId> parseTileName(const std::string& text) {
  std::array<std::int64_t, 3> tile{};
  const std::vector<std::string_view> pieces = split(text, '/');
  bool fine = pieces.size() == tile.size();
  for (std::size_t k = 0; fine && k < tile.size(); ++k) {
    const std::optional<std::int64_t> number = parseInteger(pieces[k]);
    fine = number && *number >= 0 && *number <= (std::int64_t{2} << kMaxZoom);
    tile[k] = number.value_or(0);
  }
  if (!fine || tile[0] > kMaxZoom)
    return expected("Z/X/Y: zoom, column and row from the south, as in 12/706/2850");
  return TileId{static_cast<int>(tile[0]), static_cast<std::uint32_t>(tile[1]),
                static_cast<std::uint32_t>(tile[2])};
}

std::string tileNameText(const std::optional<TileId>& tile) {
  if (!tile)
    return {};
  return tileName(*tile);
}

Status setCompareTile(CompareOptions& options, const std::string& text) {
  const auto tile = parseTileName(text);
  if (!tile.ok())
    return tile.status();
  options.tile = *tile;
  return {};
}

std::string compareTileText(const CompareOptions& options) {
  return tileNameText(options.tile);
}

} // namespace qmesh
