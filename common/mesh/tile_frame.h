// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <vector>

#include "grid/height_tile.h"
#include "mesh/level_params.h"

namespace qmesh {

inline constexpr int kQuantizedMax = 32767;

/// The multiple of the lattice's step nearest to a height (half a step rounds up), metres.
double roundToLattice(double height, double step);

/// The frame in which a tile is decoded: where its nodes lie in (u, v) and what its heights mean.
/// A pure function of the height tile and the level. Positions are in quantized units, 0..32767
/// from west to east and from south to north (v linear in latitude in both profiles).
class TileFrame {
 public:
  /// Fills the frame for a tile; buffers are reused. Heights of all (N+1)^2 nodes set the range.
  void reset(const HeightTile& tile, const LevelParams& level);

  int cells() const { return cells_; }

  /// Exact position of node column i / row j (0..N), real.
  double nodeU(int i) const { return nodeU_[std::size_t(i)]; }
  double nodeV(int j) const { return nodeV_[std::size_t(j)]; }
  /// Position of a vertex put on that node: the rounded one; strictly increasing in i (j).
  std::uint16_t u(int i) const { return u_[std::size_t(i)]; }
  std::uint16_t v(int j) const { return v_[std::size_t(j)]; }
  /// The node column / row nearest to a quantized position.
  int nearestColumn(std::uint16_t u) const;
  int nearestRow(std::uint16_t v) const;

  float minHeight() const {
    return min_;
  } ///< header, a multiple of S (in a coarse tile: of its step)
  float maxHeight() const { return max_; } ///< header, min + 32767 S / n rounded to float32

  /// Height of quantized height q, as a client decodes it: min + q / 32767 * (max - min).
  double decode(std::uint16_t q) const { return double(min_) + double(q) * step_; }
  /// Metres between two quantized heights: what an inner vertex's height is rounded to.
  double heightStep() const { return step_; }
  /// Nearest quantized height of an interior vertex.
  std::uint16_t quantize(float height) const;
  /// Quantized height of a border vertex: the nearest multiple of the level's S, which the tile
  /// next door finds too.
  std::uint16_t quantizeBorder(float height) const;

  /// Metres by which neighbours may differ because this tile's range exceeds 32767 S and it took a
  /// coarser step; 0 as a rule.
  double coarseStep() const { return coarseStep_; }

 private:
  void setPositions(const HeightTile& tile);

  int cells_ = 0;
  std::vector<double> nodeU_, nodeV_;
  std::vector<std::uint16_t> u_, v_;
  float min_ = 0;
  float max_ = 0;
  double step_ = 0;        ///< (max - min) / 32767 from the float32 values
  double latticeStep_ = 1; ///< S, or the coarser one
  int divisions_ = 1;      ///< n
  double minMultiple_ = 0; ///< min / S, whole
  double coarseStep_ = 0;
};

} // namespace qmesh
