// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "base/status.h"
#include "codec/tile_mesh.h"

namespace qmesh {

/// Renumbers a mesh for small files: triangles in the order of a depth-first walk over their
/// neighbours (in the manner of Rossignac's Edgebreaker, 1999), vertices in the order of first use,
/// which high-water-mark encoding needs. Deterministic. `octNormals` move with their vertices.
/// Edge lists are sorted the way CesiumJS wants them (west by v ascending, south by u descending,
/// east by v descending, north by u ascending). Every triangle keeps its orientation.
/// REQUIRES: a manifold mesh, every vertex used.
void orderForEncoding(TileMesh& mesh);

/// The bytes of a .terrain file (not compressed): quantized-mesh-1.0, indices 16 bit up to 65535
/// vertices and 32 bit above. An error for 65536 vertices, which clients misread, and for a mesh
/// whose vertices are not in order of first use.
Result<std::vector<std::uint8_t>> encodeTile(const TileMesh& mesh);

}  // namespace qmesh
