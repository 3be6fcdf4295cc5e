// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "codec/decode.h"
#include "validate/finding.h"

namespace qmesh {

/// What the bytes of a tile's file (gzip or not) are. Where the strict decoder stops at a fault,
/// the parts that can be read all the same are: a broken extension leaves the mesh, indices of the
/// wrong width are read in the width they have.
struct ReadTile {
  std::optional<TileMesh> mesh;
  bool compressed = false;
  std::size_t size = 0;        ///< bytes when unpacked
  std::vector<int> extensions; ///< ids in the order of the file
};

/// Adds the findings of group `format` about the bytes. O(size). `place`: for the findings.
ReadTile readTileBytes(const std::vector<std::uint8_t>& stored, ExtensionLengths lengths,
                       const std::string& place, Findings& findings);

} // namespace qmesh
