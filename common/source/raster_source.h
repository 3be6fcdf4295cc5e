// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "source/height_options.h"
#include "source/input_options.h"
#include "source/node_source.h"

class GDALDataset;

namespace qmesh {

/// Opens a raster dataset as heights on demand. Each pixel: void test (nodata, mask, alpha, NaN),
/// scale, offset, unit to metres, sign of --bathymetry; then interpolation at the node, then
/// scaling above or below sea level, then clipping. Nodes outside --te or the cutline are void.
/// `warnings` gets sentences about what was taken on trust. `host`: an open dataset to use instead
/// of input.path, which then only names it in messages; it must outlive the source. Code::input
/// for a dataset that cannot be used, Code::usage for options that contradict it.
Result<std::shared_ptr<NodeSourceFactory>> openRasterSource(const InputOptions& input,
                                                            const HeightOptions& heights,
                                                            std::vector<std::string>& warnings,
                                                            GDALDataset* host = nullptr);

} // namespace qmesh
