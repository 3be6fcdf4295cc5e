// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "export/export_mesh.h"
#include "sink/output_options.h"

namespace qmesh {

/// --debug-meshes: a taker that writes DIR/{z}/{x}/{y}.FORMAT, rows numbered as in the set; files
/// of that name are replaced, others stay. Empty where the option is not given. What an interrupted
/// run wrote stays. Code::output where a file cannot be written.
MeshCallback meshFiles(const OutputOptions& options);

} // namespace qmesh
