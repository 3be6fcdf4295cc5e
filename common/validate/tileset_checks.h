// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>
#include <string>

#include "codec/layer_json.h"
#include "tiling/listed_tiles.h"
#include "validate/finding.h"
#include "validate/mesh_checks.h"
#include "validate/tile_bytes.h"

/// Checks of the set as a whole: its layer.json, and each tile against it.
namespace qmesh {

/// A layer.json of any producer, as far as it can be understood.
struct CheckedLayer {
  LayerJson layer;        ///< with defaults where the file is at fault
  bool available = false; ///< whether it lists tiles
};

/// Findings of group `layer` about the text; "" for a file that is not there. What is broken is
/// taken for what it probably means, so that the tiles can be looked at all the same.
CheckedLayer checkLayer(const std::string& text, Findings& findings);

/// What the list of tiles says about itself: gaps, roots, parents, zooms, bounds.
void checkListedTiles(const LayerJson& layer, const ListedTiles& listed, Findings& findings);

/// A tile against what layer.json announces: extensions and metadata.
void checkExtensions(const ReadTile& read, const TileContext& context, const LayerJson& layer,
                     const ListedTiles& listed, Findings& findings);

} // namespace qmesh
