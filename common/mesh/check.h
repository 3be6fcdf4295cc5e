// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "mesh/tin.h"

namespace qmesh {

/// Proves promise P6 for a TIN: indices in range, every vertex used, no two at one place, every
/// triangle counter-clockwise with area > 0, areas that sum to 2 * 32767^2 exactly (doubled areas),
/// every inner edge shared by two triangles in opposite directions, every other edge on the
/// square's border, not 65536 vertices. Returns an empty string, or one sentence on the first
/// fault.
std::string checkTin(const Tin& tin);

} // namespace qmesh
