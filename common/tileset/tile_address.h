// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "codec/layer_json.h"
#include "tiling/scheme.h"

namespace qmesh {

/// The layer.json a user means by `path`: the folder, the file itself, either with the prefix
/// "QMESH:", or an http(s) URL of one of the two, which becomes a /vsicurl/ path.
std::string layerJsonPath(const std::string& path);

/// Where the tiles of a set lie: the first pattern under "tiles" of its layer.json, resolved the
/// way CesiumJS resolves it.
class TileAddress {
 public:
  /// `layerPath`: as layerJsonPath() gives it.
  TileAddress(const std::string& layerPath, const LayerJson& layer);

  /// A path for VSI. Rows turn over for slippyMap; {reverseY} is the other way round of {y}. On a
  /// server the queries of the pattern and of layer.json stay, in a folder they mean nothing. An
  /// absolute pattern in a folder counts from its first placeholder on, for the server's root is
  /// not known there; the pattern of a server never leads to a file of this machine.
  std::string of(TileId tile) const;

  /// True where tiles come over the network.
  bool remote() const { return remote_; }
  /// True where the tiles are <folder>/z/x/y.terrain of the folder of layer.json.
  bool plainFolders() const;
  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;  ///< of layer.json, without a slash at the end
  std::string pattern_; ///< a whole path with placeholders
  Scheme scheme_;
  bool slippyMap_;
  bool remote_;
};

} // namespace qmesh
