// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "codec/layer_json.h"
#include "pyramid/pyramid_plan.h"
#include "pyramid/report.h"

namespace qmesh {

/// layer.json of a finished run that made the tiles `kept`. Its version is made from the tiles'
/// content, so that a browser's cache is passed by exactly when something changed.
LayerJson layerRecord(const TilesetOptions& options, const PyramidPlan& plan,
                      const Availability& kept, const BuildReport& report);

} // namespace qmesh
