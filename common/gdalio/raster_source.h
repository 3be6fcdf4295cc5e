// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "build/node_source.h"
#include "options/build_options.h"

namespace qmesh {

/// Opens a raster dataset as heights on demand. Each pixel: void test (nodata, mask, alpha, NaN),
/// scale, offset, unit to metres, sign of --bathymetry; then interpolation at the node, then
/// scaling above or below sea level, then clipping. Nodes outside --te or the cutline are void.
/// `warnings` gets sentences about what was taken on trust. Code::input for a dataset that cannot
/// be used, Code::usage for options that contradict it.
Result<std::shared_ptr<NodeSourceFactory>> openRasterSource(const BuildOptions& options,
                                                            std::vector<std::string>& warnings);

} // namespace qmesh
