// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "tiling/scheme.h"

/// The files of a finished set in a folder: which are its own, and what can be done with them as a
/// whole. Files of others in the same folder are never touched.
namespace qmesh {

/// The file that makes a folder a set.
inline constexpr const char* kLayerJsonName = "layer.json";

/// The folder in an output folder where a run works (DirectorySink).
inline constexpr const char* kHiddenFolderName = ".qmesh-build";

/// The file in it that is locked meanwhile.
inline constexpr const char* kLockFileName = "lock";

/// A tile's file in the folder of its set; `xyz`: rows from the north.
std::string tileFileName(TileId tile, bool xyz);

/// Whether a set has a file of that relative name: layer.json, a tile, the preview page, GDAL's
/// notes.
bool isTilesetFile(const std::string& name);

/// Whether the beginning of a layer.json says that its tiles are quantized meshes.
bool saysQuantizedMesh(const std::string& head);

/// Whether `folder` holds a layer.json that does; reads its first bytes only.
bool holdsTileset(const std::string& folder);

/// Whether `folder` holds anything but what a run keeps there while it works.
bool holdsFiles(const std::string& folder);

/// Removes the set: layer.json first, tiles, preview page, what GDAL noted about it (.aux.xml),
/// a stopped run's leftovers, then the folders that are empty by now. Code::output where it is no
/// set, a run works in it, or something cannot be removed.
Status deleteTileset(const std::string& folder);

/// Moves the set to a folder that is not there or empty, layer.json last. Code::output.
Status renameTileset(const std::string& from, const std::string& to);

/// Copies the set likewise; a copy that fails is removed.
Status copyTileset(const std::string& from, const std::string& to);

/// Removes what GDAL noted about the set that was in `folder` before (statistics and the like).
void removeNotes(const std::string& folder);

} // namespace qmesh
