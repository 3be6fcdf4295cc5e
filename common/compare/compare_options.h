// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>

#include "tiling/scheme.h"

namespace qmesh {

/// Whether methods are compared, and where.
struct CompareOptions {
  bool enabled = false;
  std::optional<TileId> tile; ///< unset: chosen by chooseComparedTiles()
};

} // namespace qmesh
