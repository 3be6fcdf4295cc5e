// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstdint>

#include "geo/vec3.h"

namespace qmesh {

/// A unit vector in two bytes (Cigolle et al. 2014, "oct16"): the form of the quantized-mesh
/// extension octvertexnormals and of CesiumJS's AttributeCompression.
std::array<std::uint8_t, 2> octEncode(const Vec3& unit);

/// The inverse, unit length.
Vec3 octDecode(std::array<std::uint8_t, 2> encoded);

} // namespace qmesh
