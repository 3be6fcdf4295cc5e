// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "sink/mesh_files.h"

#include "export/mesh_writers.h"
#include "vsi/vsi_files.h"

namespace qmesh {

MeshCallback meshFiles(const OutputOptions& options) {
  if (options.debugMeshes.empty())
    return {};
  return [folder = options.debugMeshes, format = options.debugFormat,
          xyz = options.xyz](TileId tile, const ExportMesh& mesh) {
    const std::uint32_t row = xyz ? (std::uint32_t(1) << tile.z) - 1 - tile.y : tile.y;
    const std::string text = meshText(mesh, format, MeshFrame::local);
    return writeWholeFile(folder + "/" + std::to_string(tile.z) + "/" + std::to_string(tile.x) +
                              "/" + std::to_string(row) + "." + enumName(format),
                          text.data(), text.size());
  };
}

} // namespace qmesh
