// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/tile_job.h"

#include <cmath>

#include "base/hash.h"
#include "base/stopwatch.h"
#include "codec/encode.h"
#include "geo/bounding.h"
#include "geo/ellipsoid.h"
#include "geo/octahedral.h"
#include "pyramid/inherit/inherited_border.h"

namespace qmesh {

namespace {

std::string nameOf(TileId id) {
  return std::to_string(id.z) + "/" + std::to_string(id.x) + "/" + std::to_string(id.y);
}

/// Vertices on each of the four edges; encoding puts them in order.
void listEdges(const Tin& tin, TileMesh& mesh) {
  for (auto& edge : mesh.edges)
    edge.clear();
  for (std::uint32_t k = 0; k < tin.vertices.size(); ++k) {
    const TinVertex& v = tin.vertices[k];
    if (v.u == 0)
      mesh.edges[kWest].push_back(k);
    if (v.v == 0)
      mesh.edges[kSouth].push_back(k);
    if (v.u == kQuantizedMax)
      mesh.edges[kEast].push_back(k);
    if (v.v == kQuantizedMax)
      mesh.edges[kNorth].push_back(k);
  }
}

LevelStats statsOf(const Tin& tin, const TileFrame& frame) {
  LevelStats stats;
  stats.tiles = 1;
  stats.vertices = tin.vertices.size();
  stats.triangles = tin.triangles.size();
  stats.nodes = std::uint64_t(frame.cells() + 1) * std::uint64_t(frame.cells() + 1);
  stats.maxError = tin.maxError;
  stats.sumSquaredError = std::uint64_t(std::llround(tin.sumSquaredError * 1000));
  stats.quantizationTiles = tin.reason == StopReason::quantization ? 1 : 0;
  stats.coarseTiles = frame.coarseStep() > 0 ? 1 : 0;
  stats.largestCoarseStep = frame.coarseStep();
  return stats;
}

} // namespace

TileJob::TileJob(const MethodOptions& method, const OutputOptions& output)
    : extensions_(extensionProviders(output)), compress_(output.compression == Compression::gzip) {
  const Result<const SimplifierInfo*> info = chosenSimplifier(method);
  if (info.ok())
    simplifier_ = (*info)->create(method);
  else
    made_ = info.status();
}

void TileJob::fillHeader(const GeoBox& box) {
  positions_.clear();
  for (const TinVertex& v : tin_.vertices) {
    const double lon = box.west + (box.east - box.west) * (v.u / double(kQuantizedMax));
    const double lat = box.south + (box.north - box.south) * (v.v / double(kQuantizedMax));
    positions_.push_back(wgs84::toEcef(lon, lat, frame_.decode(v.q)));
  }
  mesh_.header.sphere = boundingSphere(positions_);
  mesh_.header.centre = mesh_.header.sphere.centre;
  mesh_.header.horizon = horizonOcclusionPoint(mesh_.header.centre, positions_);
  mesh_.header.minHeight = frame_.minHeight();
  mesh_.header.maxHeight = frame_.maxHeight();
}

void TileJob::assemble(const HeightTile& tile, const KeptTiles* kept) {
  mesh_.u.clear();
  mesh_.v.clear();
  mesh_.q.clear();
  mesh_.indices.clear();
  for (const TinVertex& v : tin_.vertices) {
    mesh_.u.push_back(v.u);
    mesh_.v.push_back(v.v);
    mesh_.q.push_back(v.q);
  }
  for (const TinTriangle& t : tin_.triangles) {
    mesh_.indices.insert(mesh_.indices.end(), t.begin(), t.end());
  }
  listEdges(tin_, mesh_);
  fillHeader(tile.lattice().scheme().box(tile.id()));
  mesh_.extensions = {};
  for (const auto& provider : extensions_)
    provider->provide({tile, frame_, tin_, kept}, mesh_.extensions);
  orderForEncoding(mesh_);
}

Status TileJob::run(const HeightTile& tile, const LevelParams& level, const KeptTiles* kept,
                    TileResult& result, StepSeconds& seconds) {
  QMESH_RETURN_IF_ERROR(made_);
  Stopwatch watch;
  frame_.reset(tile, level);
  border_.isFree = {};
  simplifier_->makeBorder(tile, frame_, level, border_);
  seconds[int(Step::mesh)] += watch.lap();
  return simplifyAndEncode(tile, level, kept, result, seconds);
}

Status TileJob::run(const HeightTile& tile, const LevelParams& level, const KeptTiles* kept,
                    Border& border, TileResult& result, StepSeconds& seconds) {
  QMESH_RETURN_IF_ERROR(made_);
  Stopwatch watch;
  frame_.reset(tile, level);
  border_ = border;
  completeBorder(*simplifier_, tile, frame_, level, border_);
  seconds[int(Step::mesh)] += watch.lap();
  QMESH_RETURN_IF_ERROR(simplifyAndEncode(tile, level, kept, result, seconds));
  listBorder(tin_, border);
  return {};
}

Status TileJob::simplifyAndEncode(const HeightTile& tile, const LevelParams& level,
                                  const KeptTiles* kept, TileResult& result, StepSeconds& seconds) {
  Stopwatch watch;
  QMESH_RETURN_IF_ERROR(simplifier_->simplify(tile, frame_, border_, level, tin_));
  seconds[int(Step::mesh)] += watch.lap();

  assemble(tile, kept);
  auto bytes = encodeTile(mesh_);
  if (!bytes.ok()) {
    return {bytes.status().code(), "tile " + nameOf(tile.id()) + ": " + bytes.status().message()};
  }
  const TileId id = tile.id();
  const std::uint64_t name = (std::uint64_t(id.z) << 58) ^ (std::uint64_t(id.x) << 29) ^ id.y;
  result.fingerprint = fingerprint(bytes->data(), bytes->size(), name);
  result.bytes = compress_ ? gzip_.compress(*bytes) : std::move(*bytes);
  result.stats = statsOf(tin_, frame_);
  result.stats.bytes = result.bytes.size();
  seconds[int(Step::encode)] += watch.lap();
  return {};
}

ExportMesh TileJob::exportMesh(const HeightTile& tile) const {
  ExportMesh mesh;
  mesh.name = "tile " + nameOf(tile.id());
  mesh.box = tile.lattice().scheme().box(tile.id());
  for (std::size_t k = 0; k < mesh_.vertexCount(); ++k)
    mesh.vertices.push_back({double(mesh_.u[k]), double(mesh_.v[k]), frame_.decode(mesh_.q[k])});
  for (std::size_t k = 0; k < mesh_.indices.size(); k += 3)
    mesh.triangles.push_back({mesh_.indices[k], mesh_.indices[k + 1], mesh_.indices[k + 2]});
  for (std::size_t k = 0; k < mesh_.extensions.normals.size(); k += 2)
    mesh.normals.push_back(
        octDecode({mesh_.extensions.normals[k], mesh_.extensions.normals[k + 1]}));
  return mesh;
}

} // namespace qmesh
