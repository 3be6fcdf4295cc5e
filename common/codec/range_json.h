// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "tiling/availability.h"

namespace qmesh {

/// A level's rectangles as a JSON list of objects {startX, startY, endX, endY}, with `gap` before
/// each object and `end` after the last.
std::string rangesJson(const std::vector<TileRange>& ranges, const std::string& gap = {},
                       const std::string& end = {});

} // namespace qmesh
