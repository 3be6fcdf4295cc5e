// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>

#include "codec/decode.h"
#include "codec/encode.h"
#include "require.h"

namespace {

using qmesh::fuzz::require;

bool isBelow(const std::vector<std::uint32_t>& indices, std::size_t limit) {
  return std::all_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < limit; });
}

void requireValid(const qmesh::TileMesh& mesh) {
  const std::size_t count = mesh.vertexCount();
  require(mesh.v.size() == count && mesh.q.size() == count, "arrays of one length");
  require(mesh.extensions.normals.empty() || mesh.extensions.normals.size() == 2 * count,
          "a normal a vertex");
  require(mesh.triangleCount() > 0 && mesh.indices.size() % 3 == 0, "whole triangles");
  require(isBelow(mesh.indices, count), "indices in range");
  for (const auto& edge : mesh.edges)
    require(isBelow(edge, count), "edge indices in range");
}

} // namespace

/// Any bytes: decoding ends in an error or a valid mesh, and what can be written reads back alike.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto mesh = qmesh::decodeTile(data, size);
  if (!mesh.ok())
    return 0;
  requireValid(*mesh);
  const auto bytes = qmesh::encodeTile(*mesh);
  if (!bytes.ok())
    return 0;
  const auto again = qmesh::decodeTile(bytes->data(), bytes->size());
  require(again.ok(), "our own bytes can be decoded");
  require(again->indices == mesh->indices && again->u == mesh->u && again->edges == mesh->edges,
          "decoding what was encoded gives the mesh back");
  return 0;
}
