// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/status.h"
#include "sink/output_options.h"
#include "sink/tile_sink.h"

namespace qmesh {

/// A folder as the place of a tileset: {z}/{x}/{y}.terrain, rows from the north with --xyz. The
/// tileset grows in the hidden folder OUTPUT/.qmesh-build and takes its place at commit(); until
/// then, and after abandon() or an error, OUTPUT is as it was. What a killed run left there is put
/// right and removed by the next one. Files that are not ours stay where they are. Found here,
/// before any work, all Code::output: OUTPUT is or lies below a file, is not empty and
/// --overwrite is not given, cannot be written, is in use by another run.
Result<OpenedSink> openDirectorySink(const OutputOptions& options);

} // namespace qmesh
