// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "tileset/tileset.h"
#include "validate/finding.h"

namespace qmesh {

/// A set of any producer, opened as far as it can be.
struct OpenedTileset {
  Tileset set;
  Findings layerFindings; ///< of its layer.json; none for one tile alone
  bool listed = false;    ///< whether layer.json lists the tiles
  bool announced = false; ///< whether there is a layer.json that says what tiles have
};

/// Opens a folder, layer.json, tile or address. A layer.json with faults is mended and the faults
/// are told; where it is missing or no JSON the tiles in the folder make the set, if there are any.
/// Code::input where nothing can be looked at.
Result<OpenedTileset> openTileset(const std::string& path);

} // namespace qmesh
