// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "export/mesh_writers.h"

namespace qmesh {

/// A picture: three bytes (red, green, blue) a pixel, row by row from the top.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  std::uint8_t* at(int column, int row) {
    return pixels.data() + 3 * (std::size_t(row) * std::size_t(width) + std::size_t(column));
  }
};

/// The same drawing as svgText(), in pixels; smooth lines (each pixel is the mean of 3 x 3).
/// vsi/png_file.h writes it as a PNG file.
RgbImage paintMesh(const ExportMesh& mesh, const MeshDrawing& drawing);

} // namespace qmesh
