// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "codec/tile_mesh.h"

namespace qmesh::test {

//   vertex 3 (0,32767) q 32767 +---------+ vertex 2 (32767,32767) q 100
//                              |       / |
//                              |  1  /   |     triangle 0: 0 1 2
//                              |   /  0  |     triangle 1: 0 2 3
//                              | /       |
//          vertex 0 (0,0) q 0  +---------+ vertex 1 (32767,0) q 99
//
/// The tile of the drawing, written by hand from the quantized-mesh-1.0 specification.
inline std::vector<std::uint8_t> goldenBytes() {
  return {// centre 1.0, -2.0, 0.5 (doubles)
          0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 0x00, 0xc0, 0, 0, 0, 0, 0, 0, 0xe0, 0x3f,
          // least height -1.5, greatest 256 (floats)
          0x00, 0x00, 0xc0, 0xbf, 0x00, 0x00, 0x80, 0x43,
          // sphere: centre 0, 0, 2.0, radius 3.0
          0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x00, 0x40, 0, 0, 0, 0,
          0, 0, 0x08, 0x40,
          // horizon point -1.0, 0, 4.0
          0, 0, 0, 0, 0, 0, 0xf0, 0xbf, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x10, 0x40,
          // 4 vertices
          4, 0, 0, 0,
          // u: 0, +32767, 0, -32767; zig-zag 0, 65534, 0, 65533
          0, 0, 0xfe, 0xff, 0, 0, 0xfd, 0xff,
          // v: 0, 0, +32767, 0
          0, 0, 0, 0, 0xfe, 0xff, 0, 0,
          // q: 0, +99, +1, +32667; zig-zag 0, 198, 2, 65334
          0, 0, 198, 0, 2, 0, 0x36, 0xff,
          // 2 triangles: new new new; 3 back from the next (0), 1 back (2), new
          2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 1, 0, 0, 0,
          // west 0 3, south 1 0, east 2 1, north 3 2
          2, 0, 0, 0, 0, 0, 3, 0, 2, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0, 2, 0, 0, 0, 3, 0,
          2, 0,
          // extension 1: normals, 8 bytes
          1, 8, 0, 0, 0, 128, 128, 255, 128, 128, 255, 0, 1,
          // extension 2: water mask, all water
          2, 1, 0, 0, 0, 255,
          // extension 4: metadata, its own length, "{}"
          4, 6, 0, 0, 0, 2, 0, 0, 0, '{', '}'};
}

inline TileMesh goldenMesh() {
  TileMesh mesh;
  mesh.header = {{1, -2, 0.5}, -1.5f, 256.f, {{0, 0, 2}, 3}, {-1, 0, 4}};
  mesh.u = {0, 32767, 32767, 0};
  mesh.v = {0, 0, 32767, 32767};
  mesh.q = {0, 99, 100, 32767};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.edges = {{{0, 3}, {1, 0}, {2, 1}, {3, 2}}};
  mesh.extensions.normals = {128, 128, 255, 128, 128, 255, 0, 1};
  mesh.extensions.waterMask = {255};
  mesh.extensions.metadata = "{}";
  return mesh;
}

} // namespace qmesh::test
