// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/status.h"
#include "export/export_mesh.h"
#include "mesh/level_params.h"
#include "pyramid/tileset_options.h"
#include "source/node_source.h"
#include "tiling/availability.h"

namespace qmesh {

/// What a run makes: zooms, tiles per zoom and parameters per level. A function of the options and
/// of the input's extent and resolution alone; const while the run goes on.
struct PyramidPlan {
  Scheme scheme{Profile::geodetic};
  int cells = 256;
  int minZoom = 0;
  int maxZoom = 0;
  std::vector<LevelParams> levels;  ///< by zoom, 0..maxZoom
  Availability tiles;               ///< every tile of minZoom..maxZoom, roots included
  Availability support;             ///< the same down to level 0: where nodes have a meaning
  std::vector<TileRange> dataTiles; ///< tiles of maxZoom: the nodes taken from the input
  GeoBox bounds; ///< of the data, degrees; east up to 540 across the antimeridian

  NodeLattice lattice(int zoom) const { return {scheme, zoom, cells}; }
  std::uint64_t tileCount() const;
};

/// All that decides what the tiles are; const while a run goes on.
struct TilesetInput {
  TilesetOptions options;
  const PyramidPlan& plan;
  const NodeSourceFactory& source;
  MeshCallback meshes = {}; ///< of every tile written (--debug-meshes); empty: nobody wants them
};

/// Plans the pyramid. Tiles are those whose square meets the data's extent at the maximum zoom
/// (within --min-x..--max-y), their ancestors, and at level 0 every root. Code::usage where the
/// zooms or a SPEC make no sense, Code::input where no tile is left.
Result<PyramidPlan> planPyramid(const TilesetOptions& options, const NodeSourceFactory& source);

} // namespace qmesh
