// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tin.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// The vertices that are left of a triangulation, in the order of their numbers, and its triangles
/// by places in that list; both are overwritten.
void listMesh(const Triangulation& mesh, std::vector<std::int32_t>& vertices,
              std::vector<TinTriangle>& triangles);

} // namespace qmesh
