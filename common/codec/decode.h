// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/status.h"
#include "codec/tile_mesh.h"

namespace qmesh {

/// How a tile writes the lengths of its extensions: the way of the format, or that of old servers,
/// whose layer.json calls the normals "vertexnormals" (CesiumJS tells them apart by that word).
enum class ExtensionLengths { littleEndian, bigEndian };

/// Reads the bytes of a .terrain file (not compressed). Never reads outside [data, data + size),
/// never allocates by a count that the bytes left could not hold, never yields an index out of
/// range, a position or height above 32767, no triangle or a least or greatest height that is not a
/// number (the rest of the header is as it stands). Unknown extensions are passed over.
/// Code::input with one sentence on the first fault.
Result<TileMesh> decodeTile(const std::uint8_t* data, std::size_t size,
                            ExtensionLengths lengths = ExtensionLengths::littleEndian);

} // namespace qmesh
