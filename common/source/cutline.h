// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include <ogr_spatialref.h>

#include "base/status.h"
#include "source/input_options.h"
#include "source/pixel_frame.h"
#include "source/region.h"

namespace qmesh {

/// The polygons of every layer of a vector dataset; without a coordinate system of its own a layer
/// takes the raster's. Code::input where it cannot be opened or has no polygon.
Result<Region> readCutline(const std::string& path, const OGRSpatialReference& rasterSrs);

/// The rectangle of --te, in --te-srs or the raster's own system. Code::usage where it is empty or
/// --te-srs is unknown, Code::input where it has no place on the globe.
Result<Region> readExtent(const InputOptions& options, const OGRSpatialReference& rasterSrs);

} // namespace qmesh
