// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geo/bounding.h"
#include "geo/vec3.h"

namespace qmesh {

/// The header of a quantized-mesh-1.0 tile.
struct TileHeader {
  Vec3 centre;         ///< ECEF, metres
  float minHeight = 0; ///< metres
  float maxHeight = 0;
  Sphere sphere; ///< ECEF, metres
  Vec3 horizon;  ///< scaled space, see horizonOcclusionPoint()
};

/// What a tile carries beside its triangles: the extensions of quantized-mesh-1.0, empty where the
/// tile has none.
struct TileExtensions {
  std::vector<std::uint8_t> normals;   ///< id 1: oct-encoded, 2 bytes per vertex
  std::vector<std::uint8_t> waterMask; ///< id 2: 1 byte, or 256 x 256 bytes, north row first
  std::string metadata;                ///< id 4: JSON

  bool operator==(const TileExtensions& o) const {
    return normals == o.normals && waterMask == o.waterMask && metadata == o.metadata;
  }
};

/// A tile as the file holds it. All vertex arrays have one length; positions and heights 0..32767.
struct TileMesh {
  TileHeader header;
  std::vector<std::uint16_t> u, v, q;
  std::vector<std::uint32_t> indices;              ///< three a triangle
  std::array<std::vector<std::uint32_t>, 4> edges; ///< west, south, east, north
  TileExtensions extensions;

  std::size_t vertexCount() const { return u.size(); }
  std::size_t triangleCount() const { return indices.size() / 3; }
};

} // namespace qmesh
