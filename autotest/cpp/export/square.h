// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "export/export_mesh.h"

namespace qmesh {

/// One degree at the equator, two triangles; the north-east corner is 1000 m high.
///   3 - 2
///   | / |
///   0 - 1
inline ExportMesh square() {
  ExportMesh mesh;
  mesh.name = "a <square>";
  mesh.box = {10, 0, 11, 1};
  mesh.vertices = {{0, 0, 0}, {32767, 0, 0}, {32767, 32767, 1000}, {0, 32767, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

} // namespace qmesh
