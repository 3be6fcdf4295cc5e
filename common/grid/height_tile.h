// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>

#include "tiling/node_lattice.h"

namespace qmesh {

/// Nodes around a tile that its normals (one) and curvature (two) need.
inline constexpr int kTileHalo = 2;

/// The nodes of one tile with its halo: a view into a block's buffer, all finite (voids filled).
/// Metres. Nodes beyond a pole or beyond the mercator square do not exist: use
/// `firstRow`/`lastRow`.
class HeightTile {
 public:
  /// `origin` points at the south-west node (0, 0) of the tile; rows are `stride` floats apart and
  /// go north. The buffer must cover -2..N+2 in both directions, but for rows that do not exist.
  /// `filled`, if not null, has the same layout and is not 0 where the height only fills a void.
  HeightTile(TileId id, const NodeLattice& lattice, const float* origin, std::ptrdiff_t stride,
             const std::uint8_t* filled = nullptr)
      : id_(id), lattice_(lattice), origin_(origin), stride_(stride), filled_(filled) {}

  TileId id() const { return id_; }
  const NodeLattice& lattice() const { return lattice_; }
  int cells() const { return lattice_.cells(); }

  /// Height of the tile's node (i, j), each in -2..N+2, j within firstRow()..lastRow().
  float at(int i, int j) const { return origin_[std::ptrdiff_t(j) * stride_ + i]; }
  const float* row(int j) const { return origin_ + std::ptrdiff_t(j) * stride_; }

  /// True where the node has no data of its own but a constant fill.
  bool isFilled(int i, int j) const {
    return filled_ && filled_[std::ptrdiff_t(j) * stride_ + i] != 0;
  }

  /// Global position of node (0, 0).
  std::int64_t column0() const { return std::int64_t(id_.x) * cells(); }
  std::int64_t row0() const { return std::int64_t(id_.y) * cells(); }

  /// The rows of the halo that exist: -2 and N+2, less at the ends of the lattice.
  int firstRow() const { return row0() == 0 ? 0 : -kTileHalo; }
  int lastRow() const {
    return row0() + cells() == lattice_.lastRow() ? cells() : cells() + kTileHalo;
  }

 private:
  TileId id_;
  NodeLattice lattice_;
  const float* origin_;
  std::ptrdiff_t stride_;
  const std::uint8_t* filled_;
};

} // namespace qmesh
