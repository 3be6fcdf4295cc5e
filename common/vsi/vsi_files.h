// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/status.h"

/// Files and folders through GDAL's virtual file systems. Paths as GDAL takes them, without a slash
/// at the end.
namespace qmesh {

/// True for paths on this machine's own file systems.
bool isLocalPath(const std::string& path);

bool pathExists(const std::string& path);
bool isFolder(const std::string& path);

/// Names in a folder, without "." and "..", sorted; empty where it cannot be read.
std::vector<std::string> listFolder(const std::string& path);

/// Makes a folder and those above it. The ones that were missing are added to `made`, the outermost
/// first. Code::output with the system's reason.
Status makeFolders(const std::string& path, std::vector<std::string>* made = nullptr);

/// Writes a file whole; folders above it are made when they are missing. Every step is checked:
/// Code::output with the file and the system's reason; a part written stays behind.
Status writeWholeFile(const std::string& path, const void* bytes, std::size_t count);

/// Renames a file or folder; the folder of `to` must exist. Code::output when that fails.
Status renamePath(const std::string& from, const std::string& to);

/// Removes a file, or a folder with all that is in it; what cannot be removed stays.
void removeTree(const std::string& path);

/// Code::output: `sentence` and the reason errno gives.
Status outputError(const std::string& sentence, int error);

} // namespace qmesh
