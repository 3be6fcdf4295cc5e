// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <vector>

#include "codec/layer_json.h"
#include "codec/tile_mesh.h"
#include "mesh/normals.h"
#include "pyramid/kept_tiles.h"
#include "sink/output_options.h"

namespace qmesh {

/// What an extension of a tile can be made from.
struct ExtensionInput {
  const HeightTile& tile;
  const TileFrame& frame;
  const Tin& tin;
  const KeptTiles* kept = nullptr; ///< null: a tile by itself, in no tileset
};

/// Makes one extension for every tile of a tileset. Const; threads share it. The result is a
/// function of the input alone.
class ExtensionProvider {
 public:
  virtual ~ExtensionProvider() = default;
  /// Adds the extension's name to layer.json, and keys of its own.
  virtual void announce(LayerJson& layer) const = 0;
  /// Sets its part of `extensions`, or leaves it empty where this tile has none.
  virtual void provide(const ExtensionInput& input, TileExtensions& extensions) const = 0;
};

/// The providers that the options ask for, in the order in which layer.json names them.
std::vector<std::unique_ptr<const ExtensionProvider>>
extensionProviders(const OutputOptions& options);

} // namespace qmesh
