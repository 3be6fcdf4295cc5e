// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "grid/height_tile.h"
#include "mesh/level_params.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"

namespace qmesh {

/// What a method does last with a TIN that is complete but for its measures: leaves the forbidden
/// count of vertices, measures the error at every node, and says why the method stopped -
/// `reason`, or StopReason::quantization where that is maxError and does not hold.
void finishTin(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
               StopReason reason, Tin& tin);

/// Gives a TIN of kForbiddenVertexCount vertices one more, within its largest triangle and on its
/// plane (to the frame's step). Others stay as they are.
void avoidForbiddenVertexCount(const TileFrame& frame, Tin& tin);

} // namespace qmesh
