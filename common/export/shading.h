// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "export/mesh_writers.h"

namespace qmesh {

using Rgb = std::array<std::uint8_t, 3>;

inline constexpr Rgb kLineColour = {70, 70, 70};
inline constexpr Rgb kBorderColour = {200, 30, 30};

/// The colour of each triangle.
std::vector<Rgb> triangleColours(const ExportMesh& mesh, MeshShade shade);

/// "#rrggbb".
std::string hexColour(const Rgb& colour);

} // namespace qmesh
