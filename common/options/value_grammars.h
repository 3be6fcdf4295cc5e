// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "base/status.h"
#include "options/build_options.h"

/// Readers and writers of the options whose values have a grammar of their own. A reader says in
/// its status what it expected; a writer gives text the reader takes.
namespace qmesh {

/// "MIN-MAX", "MIN-" or "N" (that zoom alone) into minZoom and maxZoom.
Status setZooms(BuildOptions& options, const std::string& text);
std::string zoomsText(const BuildOptions& options);

/// Bytes, or a number with K, M, G or T (of 1024; "MB", "MiB" and so on alike), or a percentage of
/// the machine's memory.
Status setMemory(BuildOptions& options, const std::string& text);
std::string memoryText(const BuildOptions& options);

/// 1..1024 or ALL_CPUS.
Status setThreads(BuildOptions& options, const std::string& text);
std::string threadsText(const BuildOptions& options);

/// "XMIN YMIN XMAX YMAX", blanks or commas between.
Status setExtent(BuildOptions& options, const std::string& text);
std::string extentText(const BuildOptions& options);

/// "LON,LAT[,HEIGHT]", blanks or commas between: degrees (-180..180, -90..90) and metres.
Status setObserver(BuildOptions& options, const std::string& text);
std::string observerText(const BuildOptions& options);

/// A height in metres or "interpolate".
Status setVoidFill(BuildOptions& options, const std::string& text);
std::string voidFillText(const BuildOptions& options);

/// A power of two, 8..1024.
Status setTileSize(BuildOptions& options, const std::string& text);
std::string tileSizeText(const BuildOptions& options);

/// "Z/X/Y" as in 12/706/2850: zoom, column and row from the south.
Result<std::array<std::int64_t, 3>> parseTileName(const std::string& text);
std::string tileNameText(const std::optional<std::array<std::int64_t, 3>>& tile);
Status setCompareTile(BuildOptions& options, const std::string& text);
std::string compareTileText(const BuildOptions& options);

/// "auto", 2, 4 or 8.
Status setBlockTiles(BuildOptions& options, const std::string& text);
std::string blockTilesText(const BuildOptions& options);

/// The value a DEM marks its voids with: any number, "nan" and infinities included.
Status setNodata(BuildOptions& options, const std::string& text);
std::string nodataText(const BuildOptions& options);

/// Heights beyond these (metres) are no terrain.
inline constexpr double kLowestHeight = -100000;
inline constexpr double kHighestHeight = 100000;

inline constexpr int kSmallestTile = 8;
inline constexpr int kLargestTile = 1024;

} // namespace qmesh
