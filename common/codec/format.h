// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>

/// Facts of the quantized-mesh-1.0 format that writer and reader share. All numbers in a file are
/// little-endian, on every machine.
namespace qmesh::format {

inline constexpr std::size_t kHeaderSize = 88; ///< bytes
inline constexpr int kQuantizedMax = 32767;

/// Above this count indices take 32 bits.
inline constexpr std::size_t kMaxVertices16 = 65536;

/// Clients disagree on the width of the indices of a tile with exactly so many vertices.
inline constexpr std::size_t kAmbiguousVertices = 65536;

enum Extension : std::uint8_t { kOctNormals = 1, kWaterMask = 2, kMetadata = 4 };

inline constexpr std::size_t kWaterMaskSize = 256 * 256;

/// Small differences of either sign as small unsigned numbers: 0, -1, 1, -2 ... become 0, 1, 2, 3
/// ...
inline std::uint16_t zigZag(int value) {
  return std::uint16_t((value * 2) ^ (value >> 31));
}
inline int unZigZag(std::uint16_t code) {
  return (code >> 1) ^ -(code & 1);
}

} // namespace qmesh::format
