// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "tiling/node_lattice.h"

namespace qmesh {

/// Heights on demand, for one thread. What a node gets depends on its global position alone, never
/// on the window it is asked in.
class NodeSource {
 public:
  virtual ~NodeSource() = default;

  /// Heights in metres of the nodes i0..i0+width-1 (wrapped), j0..j0+height-1 of the lattice it
  /// was opened for; node (i0 + a, j0 + b) goes to out[b * stride + a]. NaN where there is no data.
  /// REQUIRES: 0 <= j0, j0 + height - 1 <= lastRow().
  virtual Status sample(std::int64_t i0, std::int64_t j0, int width, int height, float* out,
                        std::ptrdiff_t stride) = 0;
};

/// The input as a whole: what is known before sampling, and the maker of NodeSources. Const after
/// it is opened; threads share it.
class NodeSourceFactory {
 public:
  virtual ~NodeSourceFactory() = default;

  /// Where there may be data: boxes in degrees, west in -180..180, east > west and up to 540 where
  /// a box crosses the antimeridian; 360 wide when it goes round.
  virtual const std::vector<GeoBox>& extent() const = 0;

  /// First zoom whose node spacing is not coarser than the smaller side of the input's cell at its
  /// centre, 0..kMaxZoom.
  virtual int nativeZoom(const Scheme& scheme, int cellsPerTile) const = 0;

  /// Height of a pole (south: lowest row), one value for all levels; NaN where there is no data.
  virtual double poleHeight(bool north) const = 0;

  /// Called first in every thread of the work but the one that opened the input.
  virtual void enterThread() const {}

  /// A source for one thread that samples this lattice; opens its own dataset.
  virtual Result<std::unique_ptr<NodeSource>> open(const NodeLattice& lattice) const = 0;

  /// Whether any cell of the input has a height; reads all of it until one is found. Asked only
  /// when no node of the finest level got one.
  virtual Result<bool> hasData() const = 0;

  /// Bytes of memory one NodeSource takes at most.
  virtual std::size_t bytesPerSource() const = 0;
};

} // namespace qmesh
