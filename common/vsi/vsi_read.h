// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"

namespace qmesh {

/// The bytes of a file; nothing where there is no such file (on a server: answer 403, 404 or 410).
using FileBytes = std::optional<std::vector<std::uint8_t>>;

/// Reads a file of at most `maxSize` bytes whole, through GDAL's virtual file systems.
/// "/vsicurl/URL" is read with as few requests as possible: no listing, no HEAD. Code::input with
/// the file and the reason where it is larger or cannot be read.
Result<FileBytes> readWholeFile(const std::string& path, std::size_t maxSize);

} // namespace qmesh
