// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "export/export_choices.h"
#include "export/export_mesh.h"

/// Meshes as text for other programs and for people. The texts depend on the mesh alone: lengths
/// are rounded to 0.1 mm, degrees to 1e-9. Files in ASCII, lines end in "\n".
namespace qmesh {

/// Wavefront OBJ: "v", "vn" where the mesh has normals, "f"; indices from 1. Normals are turned
/// into the frame (MeshFrame::lonlat: east, north, up).
std::string objText(const ExportMesh& mesh, MeshFrame frame);

/// Stanford PLY 1.0, format ascii: vertex x y z (double), nx ny nz where the mesh has normals, face
/// vertex_indices.
std::string plyText(const ExportMesh& mesh, MeshFrame frame);

/// Geomview OFF: vertices and triangles.
std::string offText(const ExportMesh& mesh, MeshFrame frame);

/// One of the above.
std::string meshText(const ExportMesh& mesh, MeshFormat format, MeshFrame frame);

/// How a mesh is drawn: seen from above, north up, as wide and high as the box is in metres.
struct MeshDrawing {
  int width = 1024; ///< pixels, 16 at least; the height follows, a quarter to four times of it
  MeshShade shade = MeshShade::height;
  bool lines = true; ///< draw the triangles' edges; those of the mesh's border are always drawn
};

/// Scalable Vector Graphics: one path a triangle, the border drawn over them, broad and red.
std::string svgText(const ExportMesh& mesh, const MeshDrawing& drawing);

} // namespace qmesh
