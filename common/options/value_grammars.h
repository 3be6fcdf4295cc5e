// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "base/status.h"
#include "compare/compare_options.h"
#include "pyramid/run_options.h"
#include "pyramid/tiling_options.h"
#include "simplify/method_options.h"
#include "source/height_options.h"
#include "source/input_options.h"

/// Readers and writers of the options whose values have a grammar of their own. A reader says in
/// its status what it expected; a writer gives text the reader takes.
namespace qmesh {

/// "MIN-MAX", "MIN-" or "N" (that zoom alone) into minZoom and maxZoom.
Status setZooms(std::optional<int>& minZoom, std::optional<int>& maxZoom, const std::string& text);
std::string zoomsText(const std::optional<int>& minZoom, const std::optional<int>& maxZoom);

/// Bytes, or a number with K, M, G or T (of 1024; "MB", "MiB" and so on alike), or a percentage of
/// the machine's memory.
Status setMemory(RunOptions& options, const std::string& text);
std::string memoryText(const RunOptions& options);

/// 1..1024 or ALL_CPUS.
Status setThreads(RunOptions& options, const std::string& text);
std::string threadsText(const RunOptions& options);

/// "XMIN YMIN XMAX YMAX", blanks or commas between.
Status setExtent(InputOptions& options, const std::string& text);
std::string extentText(const InputOptions& options);

/// "LON,LAT[,HEIGHT]", blanks or commas between: degrees (-180..180, -90..90) and metres.
Status setObserver(MethodOptions& options, const std::string& text);
std::string observerText(const MethodOptions& options);

/// A height in metres or "interpolate".
Status setVoidFill(HeightOptions& options, const std::string& text);
std::string voidFillText(const HeightOptions& options);

/// A power of two, 8..1024.
Status setTileSize(TilingOptions& options, const std::string& text);
std::string tileSizeText(const TilingOptions& options);

/// "Z/X/Y" as in 12/706/2850: zoom, column and row from the south.
Result<TileId> parseTileName(const std::string& text);
std::string tileNameText(const std::optional<TileId>& tile);
Status setCompareTile(CompareOptions& options, const std::string& text);
std::string compareTileText(const CompareOptions& options);

/// "auto", 2, 4 or 8.
Status setBlockTiles(RunOptions& options, const std::string& text);
std::string blockTilesText(const RunOptions& options);

/// The value a DEM marks its voids with: any number, "nan" and infinities included.
Status setNodata(InputOptions& options, const std::string& text);
std::string nodataText(const InputOptions& options);

} // namespace qmesh
