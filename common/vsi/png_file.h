// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "base/status.h"
#include "export/mesh_painter.h"

namespace qmesh {

/// Writes a picture as a PNG file anywhere GDAL can write. Code::output with the file and the
/// reason, a GDAL without its PNG driver included.
Status writePng(const std::string& path, const RgbImage& image);

} // namespace qmesh
