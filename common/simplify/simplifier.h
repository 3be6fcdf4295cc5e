// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "border/border.h"
#include "grid/height_tile.h"
#include "mesh/level_params.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"

namespace qmesh {

/// What the methods may be told beside the level's parameters.
struct MethodOptions {
  bool decimate = true; ///< greedy: the bounded decimation pass
};

/// Turns the nodes of one tile into a TIN. An instance owns its scratch memory and serves one
/// thread; distinct instances share nothing. The result is a pure function of the arguments.
class Simplifier {
 public:
  virtual ~Simplifier() = default;

  /// The TIN has exactly the border's vertices on its edges and passes checkTin(); `out` is
  /// overwritten. An error names the tile.
  virtual Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                          const LevelParams& level, Tin& out) = 0;

  /// True where every node is a vertex and `border` is not asked for.
  virtual bool usesAllNodes() const { return false; }
};

/// One row a method.
struct SimplifierInfo {
  const char* name;     ///< as in --method
  const char* category; ///< "refinement", "reference", ...
  const char* sentence; ///< for --help
  bool boundsError;     ///< promise P2 holds
  std::unique_ptr<Simplifier> (*create)(const MethodOptions&);
};

const std::vector<SimplifierInfo>& simplifiers();

/// nullptr when there is no such method.
const SimplifierInfo* findSimplifier(const std::string& name);

} // namespace qmesh
