// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "codec/tile_mesh.h"
#include "tiling/scheme.h"
#include "validate/finding.h"

namespace qmesh {

/// Where a tile is.
struct TileContext {
  TileId tile;
  GeoBox box;                ///< degrees
  double geometricError = 0; ///< what CesiumJS takes the level's error for, metres
  std::string place;         ///< for the findings
};

/// Promise P6 for a tile of any producer: findings of group `mesh`, the edge lists and the vertex
/// count of group `format`. One finding a kind, with the number of cases; what only follows from
/// another fault is not told twice. O(vertices log vertices + triangles).
void checkMesh(const TileMesh& mesh, const TileContext& context, Findings& findings);

/// The header against the decoded vertices (group `header`) and the normals' directions.
/// `points`: earth-fixed places of the vertices.
void checkHeader(const TileMesh& mesh, const std::vector<Vec3>& points, const TileContext& context,
                 Findings& findings);

/// Earth-fixed places of a tile's vertices, metres.
std::vector<Vec3> earthFixed(const TileMesh& mesh, const GeoBox& box);

} // namespace qmesh
