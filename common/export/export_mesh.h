// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/status.h"
#include "geo/vec3.h"
#include "tiling/scheme.h"

namespace qmesh {

/// A vertex of a mesh that is to be shown or given to another program.
struct ExportVertex {
  double u = 0;      ///< 0..32767 from the west to the east of the box
  double v = 0;      ///< 0..32767 from the south to the north, linear in latitude
  double height = 0; ///< metres above the ellipsoid
};

/// A mesh of any origin: a decoded tile, a TIN before quantization, a set of triangles in a test.
struct ExportMesh {
  std::string name; ///< said in the file, for people; may be empty
  GeoBox box;       ///< degrees
  std::vector<ExportVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< REQUIRES: indices of vertices
  std::vector<Vec3> normals;                           ///< earth-fixed, unit; empty or one a vertex
};

/// Takes the mesh of a tile as it is encoded, for other programs; many threads call at once.
using MeshCallback = std::function<Status(TileId, const ExportMesh&)>;

} // namespace qmesh
