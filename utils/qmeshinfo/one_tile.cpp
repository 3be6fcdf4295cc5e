// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "one_tile.h"

#include <algorithm>

#include "base/text.h"
#include "export/mesh_painter.h"
#include "export/mesh_writers.h"
#include "geo/octahedral.h"
#include "surface/surface_raster.h"
#include "validate/open_tileset.h"
#include "vsi/png_file.h"
#include "vsi/vsi_files.h"

namespace qmesh {

namespace {

bool endsIn(const std::string& file, std::string_view extension) {
  return file.size() >= extension.size() &&
         equalIgnoringCase(std::string_view(file).substr(file.size() - extension.size()),
                           extension);
}

ExportMesh exportMesh(const TileReport& report) {
  const TileMesh& tile = *report.read.mesh;
  ExportMesh mesh;
  mesh.name = "tile " + tileName(report.tile);
  mesh.box = report.box;
  mesh.vertices.reserve(tile.vertexCount());
  for (std::size_t k = 0; k < tile.vertexCount(); ++k)
    mesh.vertices.push_back(
        {double(tile.u[k]), double(tile.v[k]), decodedHeight(tile.header, tile.q[k])});
  for (std::size_t t = 0; t < tile.triangleCount(); ++t)
    mesh.triangles.push_back(
        {tile.indices[3 * t], tile.indices[3 * t + 1], tile.indices[3 * t + 2]});
  for (std::size_t k = 0; k + 1 < tile.extensions.normals.size(); k += 2)
    mesh.normals.push_back(octDecode({tile.extensions.normals[k], tile.extensions.normals[k + 1]}));
  return mesh;
}

Status writeText(const std::string& path, const std::string& text) {
  return writeWholeFile(path, text.data(), text.size());
}

} // namespace

Result<TileReport> describeTile(const Tileset& set, TileId tile) {
  const Scheme scheme = set.scheme();
  if (tile.x >= scheme.tilesX(tile.z) || tile.y >= scheme.tilesY(tile.z))
    return Status(Code::input, "there is no tile " + tileName(tile) + ": zoom " +
                                   std::to_string(tile.z) + " has " +
                                   std::to_string(scheme.tilesX(tile.z)) + " columns and " +
                                   std::to_string(scheme.tilesY(tile.z)) + " rows");
  TileReport report;
  report.tile = tile;
  report.path = set.tilePath(tile);
  report.box = scheme.box(tile);
  const Result<FileBytes> bytes = set.readBytes(tile);
  if (!bytes.ok())
    return bytes.status();
  if (!*bytes)
    return Status(Code::input,
                  "there is no tile " + tileName(tile) + ": no file '" + report.path + "'");
  report.storedBytes = (*bytes)->size();
  report.read = readTileBytes(**bytes, set.extensionLengths(), tileName(tile), report.findings);
  if (!report.read.mesh) {
    const Finding first = report.findings.empty() ? Finding{204, "", ""} : report.findings[0];
    return Status(Code::input, "'" + report.path + "' cannot be decoded: " +
                                   findingKind(first.code).title + " (" + codeText(first.code) +
                                   (first.what.empty() ? "" : ": " + first.what) + ")");
  }
  const auto& q = report.read.mesh->q;
  const auto [low, high] = std::minmax_element(q.begin(), q.end());
  report.lowest = decodedHeight(report.read.mesh->header, *low);
  report.highest = decodedHeight(report.read.mesh->header, *high);
  return report;
}

Status exportTile(const TileReport& report, const InfoOptions& options) {
  if (options.exportFile.empty() && options.drawing.empty())
    return {};
  const ExportMesh mesh = exportMesh(report);
  const std::string& file = options.exportFile;
  if (endsIn(file, ".obj"))
    QMESH_RETURN_IF_ERROR(writeText(file, objText(mesh, options.frame)));
  else if (endsIn(file, ".ply"))
    QMESH_RETURN_IF_ERROR(writeText(file, plyText(mesh, options.frame)));
  else if (endsIn(file, ".off"))
    QMESH_RETURN_IF_ERROR(writeText(file, offText(mesh, options.frame)));
  MeshDrawing drawing;
  drawing.width = options.drawingWidth;
  drawing.shade = options.shade;
  if (endsIn(options.drawing, ".svg"))
    return writeText(options.drawing, svgText(mesh, drawing));
  if (endsIn(options.drawing, ".png"))
    return writePng(options.drawing, paintMesh(mesh, drawing));
  return {};
}

} // namespace qmesh
