// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "tiling/scheme.h"

namespace qmesh {

/// What a level asks of every one of its tiles: functions of the level alone, so that neighbours
/// agree (docs/architecture.md, "One definition of a node").
struct LevelParams {
  int zoom = 0;
  double maxError = 0;    ///< e, metres, >= 0
  double latticeStep = 1; ///< S, metres, a power of two: see latticeStep()
  int baseGrid = 1;       ///< cells per edge of the base grid, a power of two, 1..N

  /// What the rounding of a border vertex's height to the lattice may cost, metres, with a margin:
  /// no border can be held to less.
  double borderRounding() const { return 0.51 * latticeStep; }
};

/// The step S of the level's height lattice, metres: the smallest power of two with
/// 32767 S >= min(32767, 4 w), w the tile's north-south size, lowered to the largest power of two
/// <= maxError / 2 where that is less - but not so far that a tile of real relief, min(16000, w),
/// would not fit any more: no seam is given for a small max error. Never below 2^-10 m, so that
/// heights on Earth stay exact in the header's float32.
double latticeStep(const Scheme& scheme, int zoom, double maxErrorMetres);

/// Cells per tile edge that keep the sag of a triangle's hypotenuse on the sphere, L^2 / (4 R),
/// within `maxErrorMetres`; a power of two, at most `cellsPerTile`.
int baseGridOf(const Scheme& scheme, int zoom, double maxErrorMetres, int cellsPerTile);

LevelParams levelParams(const Scheme& scheme, int zoom, double maxErrorMetres, int cellsPerTile);

} // namespace qmesh
