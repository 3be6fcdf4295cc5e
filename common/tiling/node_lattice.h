// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>

#include "tiling/scheme.h"

namespace qmesh {

/// The lattice of height nodes of one level: (N+1)^2 nodes a tile, neighbours share edge nodes.
/// Node (i, j) is named by its global integer position: i eastwards from longitude -180, j
/// northwards from the matrix's south edge. Every property of a node is a pure function of that
/// name, so two tiles, blocks, threads or ranks that look at a node see the same bits.
/// Columns are periodic (i and i + columns() are one node); rows are 0..lastRow().
class NodeLattice {
 public:
  /// `cellsPerTile` N: a power of two, 8..1024.
  NodeLattice(Scheme scheme, int zoom, int cellsPerTile)
      : scheme_(scheme), zoom_(zoom), cells_(cellsPerTile) {}

  const Scheme& scheme() const { return scheme_; }
  int zoom() const { return zoom_; }
  int cells() const { return cells_; }

  std::int64_t columns() const { return std::int64_t(scheme_.tilesX(zoom_)) * cells_; }
  std::int64_t lastRow() const { return std::int64_t(scheme_.tilesY(zoom_)) * cells_; }

  /// i brought into 0..columns()-1.
  std::int64_t wrap(std::int64_t i) const {
    const std::int64_t n = columns();
    const std::int64_t r = i % n;
    return r < 0 ? r + n : r;
  }

  /// Degrees; `i` is wrapped first, so that -180 and +180 are one number (-180).
  double longitude(std::int64_t i) const { return scheme_.longitude(wrap(i), columns()); }
  double latitude(std::int64_t j) const { return scheme_.latitude(j, lastRow()); }

  /// True for the rows that are one point of the globe (geodetic profile only).
  bool isPole(std::int64_t j) const {
    return scheme_.profile() == Profile::geodetic && (j == 0 || j == lastRow());
  }

  /// Spacing of the columns in degrees.
  double spacingDegrees() const { return 360.0 / double(columns()); }

  NodeLattice coarser() const { return {scheme_, zoom_ - 1, cells_}; }

 private:
  Scheme scheme_;
  int zoom_;
  int cells_;
};

} // namespace qmesh
