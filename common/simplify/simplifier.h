// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/enum_table.h"
#include "base/status.h"
#include "border/border.h"
#include "grid/height_tile.h"
#include "mesh/level_params.h"
#include "mesh/tile_frame.h"
#include "mesh/tin.h"
#include "simplify/method_options.h"

namespace qmesh {

/// Turns the nodes of one tile into a TIN. An instance owns its scratch memory and serves one
/// thread; distinct instances share nothing. Results are pure functions of the arguments and of the
/// options it was made with.
class Simplifier {
 public:
  virtual ~Simplifier() = default;

  /// The vertices of the tile's edges under --border shared: a function of each edge's own nodes,
  /// of the two nodes to both sides of it, and of the level, so that both tiles of an edge find the
  /// same. Overridden by methods with a border of their own; the contract's otherwise.
  virtual void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams& level,
                          Border& border) const {
    qmesh::makeBorder(tile, frame, level, border);
  }

  /// True where simplify() adds vertices to the free edges of a border; else the caller makes those
  /// edges with makeBorder() too.
  virtual bool choosesBorder() const { return false; }

  /// The TIN has exactly the border's vertices on its final edges, at least those on its free ones,
  /// the nodes of the base grid, and passes checkTin(); `out` is overwritten. An error names
  /// the tile.
  virtual Status simplify(const HeightTile& tile, const TileFrame& frame, const Border& border,
                          const LevelParams& level, Tin& out) = 0;
};

/// One row a method.
struct SimplifierInfo {
  const char* name;     ///< as in --method
  const char* sentence; ///< for --help
  bool boundsError;     ///< promise P2 holds with the method's defaults
  bool keepsFeatures;   ///< sharp lines are edges of the mesh; MethodOptions::featureMinSize counts
  /// The SPEC option that decides how many triangles there are.
  const char* mainOption;
  /// Bytes one tile in work takes at most for each of its nodes: the method, its TIN and the
  /// encoding of it. Measured by autotest/bench/memory_per_method.py, plus a tenth or more.
  /// bytesPerNode() knows of options that take more.
  std::size_t bytesPerNode;
  std::unique_ptr<Simplifier> (*create)(const MethodOptions&);
};

/// The methods of this build, in the order of the help.
const std::vector<SimplifierInfo>& simplifiers();

/// Their names and sentences, as the option table has them.
std::vector<Choice> simplifierChoices();

/// nullptr when there is no such method.
const SimplifierInfo* findSimplifier(const std::string& name);

/// The method of these options; Code::usage with the names there are where it is unknown.
Result<const SimplifierInfo*> chosenSimplifier(const MethodOptions& options);

/// Bytes one tile in work takes at most for each of its nodes with these options.
std::size_t bytesPerNode(const SimplifierInfo& info, const MethodOptions& options);

/// "tile 7/12/34: WHAT" as Code::internal, for a method that cannot do a tile.
Status tileFault(TileId tile, const std::string& what);

} // namespace qmesh
