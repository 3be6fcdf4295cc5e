// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/height_tile.h"
#include "tiling/availability.h"
#include "tiling/node_lattice.h"

namespace qmesh {

/// A rectangle of tiles of one level with `halo` nodes around it: heights in metres, NaN where
/// there is no data. Columns are not wrapped here (a window may begin below 0 or end beyond
/// columns()); rows beyond a pole or the mercator square are part of the window and stay NaN.
/// The buffer is kept and reused by reset().
class NodeWindow {
 public:
  /// Covers the tiles x0..x1, y0..y1 (ends included) of the lattice's level; all nodes NaN.
  void reset(const NodeLattice& lattice, const TileRange& tiles, int halo);

  const NodeLattice& lattice() const { return lattice_; }
  const TileRange& tiles() const { return tiles_; }
  int halo() const { return halo_; }

  /// Global position of the first node, and the size in nodes.
  std::int64_t column0() const { return column0_; }
  std::int64_t row0() const { return row0_; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t stride() const { return width_; }

  /// Rows of the window that exist on the lattice, as window rows: first..end (one past the last).
  int firstExistingRow() const;
  int endExistingRow() const;

  /// Node by window position.
  float* row(int b) { return nodes_.data() + std::ptrdiff_t(b) * stride(); }
  const float* row(int b) const { return nodes_.data() + std::ptrdiff_t(b) * stride(); }

  /// Gives a void node a height and remembers that it was void.
  void fill(int a, int b, float height);

  /// Sets the pole rows the window holds (geodetic profile) to their one height; NaN leaves them.
  void setPoles(double southHeight, double northHeight);

  /// One of the window's tiles with its two-node halo. REQUIRES: halo() >= kTileHalo.
  HeightTile tile(TileId id) const;

  /// True when the (N+1)^2 nodes of a tile are all void.
  bool isVoid(TileId id) const;

  /// True when any node has a height.
  bool anyHeight() const;

  /// Bytes a window of that many tiles takes, marks of filled nodes included.
  static std::size_t bytes(int tilesX, int tilesY, int cells, int halo);

 private:
  NodeLattice lattice_{Scheme(Profile::geodetic), 0, 8};
  TileRange tiles_;
  int halo_ = 0;
  std::int64_t column0_ = 0;
  std::int64_t row0_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> nodes_;
  std::vector<std::uint8_t> filled_; ///< as nodes_, 1 where fill() was; empty: nowhere
};

} // namespace qmesh
