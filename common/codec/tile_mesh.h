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

/// A tile as the file holds it. All vertex arrays have one length; positions and heights 0..32767.
struct TileMesh {
  TileHeader header;
  std::vector<std::uint16_t> u, v, q;
  std::vector<std::uint32_t> indices;              ///< three a triangle
  std::array<std::vector<std::uint32_t>, 4> edges; ///< west, south, east, north
  std::vector<std::uint8_t> octNormals;            ///< extension 1: empty or 2 a vertex
  std::vector<std::uint8_t> waterMask;             ///< extension 2: empty, 1 or 65536 bytes
  std::string metadata;                            ///< extension 4: empty or JSON

  std::size_t vertexCount() const { return u.size(); }
  std::size_t triangleCount() const { return indices.size() / 3; }
};

} // namespace qmesh
