// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "base/status.h"
#include "source/raster_input.h"
#include "source/region.h"
#include "tiling/scheme.h"

namespace qmesh {

/// A raster's place on the globe: a box as in NodeSourceFactory::extent. Exact for a geographic
/// raster on WGS 84 (edges within a thousandth of a pixel of a round place are put there, so that a
/// degree tile does not reach into the next); for others a box round the transformed outline and
/// inner points. Code::input where no pixel has a place.
/// `share`: of the side of a larger raster that `input` is a part of; a part needs fewer points.
Result<GeoBox> rasterExtent(const RasterInput& input, double share = 1);

/// The same for each of the rectangles that may hold data.
Result<std::vector<GeoBox>> coverageExtent(const RasterInput& input);

/// `box` with a margin of a fiftieth of its size: no node with data lies outside.
GeoBox widened(const GeoBox& box);

/// The common part of the boxes and those round the region's polygons; as it is where the region is
/// empty.
/// Not exact where the region has more than 64 polygons: one box stands for them all.
std::vector<GeoBox> cropped(const std::vector<GeoBox>& boxes, const Region& region);

/// See NodeSourceFactory::nativeZoom.
int nativeZoomOf(const RasterInput& input, const Scheme& scheme, int cellsPerTile);

} // namespace qmesh
