// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "codec/tile_mesh.h"

namespace qmesh {

/// Finds the height of a decoded tile's surface at single places: triangles in square bins, about
/// as many as triangles. Memory O(triangles) whatever the mesh is like. Const after construction:
/// threads share it. For a whole raster rasterHeights() is faster.
class SurfaceSearch {
 public:
  /// `mesh` must outlive the search.
  explicit SurfaceSearch(const TileMesh& mesh);

  /// Height in metres at a position, 0..32767 each; of the triangle that comes first in the file
  /// where several hold it, nothing where none does. A place on an edge is in both its triangles.
  std::optional<double> heightAt(double u, double v) const;

 private:
  struct BinRange;
  BinRange binsOf(std::size_t triangle) const;
  bool countBins(std::size_t limit);
  void fillBins();
  std::optional<double> heightIn(std::size_t triangle, double u, double v) const;

  const TileMesh* mesh_;
  int side_ = 1;                     ///< bins per edge
  std::vector<std::uint32_t> begin_; ///< where each bin's triangles begin
  std::vector<std::uint32_t> triangles_;
};

} // namespace qmesh
