// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "base/status.h"
#include "sink/output_options.h"
#include "sink/tile_sink.h"

namespace qmesh {

/// True for a path below /vsizip/.
bool isZipPath(const std::string& path);

/// A zip archive as the place of a set: "/vsizip/ARCHIVE.zip", "/vsizip/ARCHIVE.zip/FOLDER" or
/// "/vsizip/{ARCHIVE}/FOLDER". An archive can only be written from its beginning to its end, so the
/// set grows in the folder ARCHIVE.qmesh-build beside it and is packed at commit(): entries in the
/// order of their names, layer.json last, without times, so that the same set is the same archive.
/// Compressed tiles are stored as they are. The archive takes its name when it is complete. Found
/// before any work, all Code::output: an archive that is there without --overwrite, one with files
/// that are not of a set, one that another run is making, a folder that cannot be written.
Result<OpenedSink> openZipSink(const OutputOptions& options);

} // namespace qmesh
