// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "codec/decode.h"

namespace qmesh {

/// Where the parts of a .terrain file lie, by its counts alone: what a decoder that stops at the
/// first fault does not tell.
struct TileLayout {
  /// A list of `count` numbers of `width` bytes.
  struct Part {
    std::size_t offset = 0; ///< bytes from the beginning
    std::size_t count = 0;
  };
  struct Extension {
    int id = 0;
    std::size_t offset = 0; ///< of its data
    std::size_t size = 0;   ///< bytes
  };

  std::string missing; ///< the part in which the bytes end too early; empty: none
  int indexWidth = 2;  ///< bytes
  Part vertices;       ///< three arrays of `count` 16-bit codes
  Part indices;        ///< three a triangle
  std::array<Part, 4> edges;
  std::size_t extensionsAt = 0; ///< 0: the bytes end before
  std::vector<Extension> extensions;
  bool extensionsFit = true; ///< false: the last one ends beyond the bytes
};

/// Walks over the counts; O(extensions). `indexWidth` 2 or 4, 0: as the number of vertices says.
TileLayout tileLayout(const std::vector<std::uint8_t>& bytes, ExtensionLengths lengths,
                      int indexWidth = 0);

/// A little-endian number of `width` bytes. REQUIRES: it lies inside.
std::uint32_t numberAt(const std::vector<std::uint8_t>& bytes, std::size_t offset, int width);

} // namespace qmesh
