// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "tiling/availability.h"
#include "tiling/scheme.h"

namespace qmesh {

/// layer.json of a quantized-mesh set: what clients read, and what we add under "qmesh".
struct LayerJson {
  std::string name;
  std::string description;
  std::string version;     ///< fills {version} in the URL
  std::string attribution; ///< the credit CesiumJS shows
  std::string format = "quantized-mesh-1.0";
  Profile profile = Profile::geodetic;
  bool slippyMap = false; ///< scheme: rows in the URL count from the north
  std::vector<std::string> tiles = {"{z}/{x}/{y}.terrain?v={version}"};
  GeoBox bounds{-180, -90, 180, 90};
  int minZoom = 0;
  int maxZoom = 0;
  /// Per zoom from 0; rows from the south whatever the scheme.
  std::vector<std::vector<TileRange>> available;
  std::vector<std::string> extensions; ///< octvertexnormals, watermask, metadata
  int metadataAvailability = 0;        ///< 0: none
  std::string parentUrl;

  /// Our own record, under the key "qmesh"; clients ignore it. Empty method: not written.
  struct Level {
    int zoom = 0;
    double maxError = 0;     ///< metres
    double errorReached = 0; ///< metres
  };
  std::string generator;
  std::string method;
  int cellsPerTile = 0;
  GeoBox extent; ///< of the data; east > 180 where it crosses the antimeridian
  std::vector<Level> levels;
};

/// The text of layer.json, two-space indented, keys in a fixed order, numbers shortest-exact; what
/// is not a number becomes null.
std::string writeLayerJson(const LayerJson& layer);

/// Reads a layer.json of any producer: absent keys take CesiumJS's defaults, unknown ones are
/// passed over, the legacy extension name "vertexnormals" is kept as it stands. Code::input with
/// one sentence where the text is not JSON, is nested deeper than 64 or larger than 256 MB, where
/// `format` is another one, `tiles` is missing, `projection` or `scheme` is one that CesiumJS does
/// not know, a range lies outside its level's matrix or `available` goes deeper than kMaxZoom.
/// Other keys with a value of the wrong kind are as if absent. An absent `maxzoom` is the deepest
/// level listed.
Result<LayerJson> readLayerJson(const std::string& text);

} // namespace qmesh
