// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "export/mesh_writers.h"

namespace qmesh {

/// Longitude and latitude (degrees) and height of a vertex.
struct Place {
  double lon = 0;
  double lat = 0;
  double height = 0;
};
Place placeOf(const ExportMesh& mesh, const ExportVertex& vertex);

/// Every vertex in the coordinates of a frame.
std::vector<Vec3> positionsIn(const ExportMesh& mesh, MeshFrame frame);

/// Every normal in the directions of a frame; empty where the mesh has none.
std::vector<Vec3> normalsIn(const ExportMesh& mesh, MeshFrame frame);

/// A mesh on paper: pixels from the left and from the top.
struct Plan {
  struct Point {
    double x = 0;
    double y = 0;
  };
  using Edge = std::array<std::uint32_t, 2>; ///< vertices

  int width = 0;
  int height = 0;
  std::vector<Point> points; ///< of the vertices
  std::vector<Edge> inner;   ///< edges of two triangles or more, each once
  std::vector<Edge> border;  ///< edges of one triangle
};
Plan planOf(const ExportMesh& mesh, int width);

} // namespace qmesh
