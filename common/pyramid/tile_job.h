// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "codec/gzip.h"
#include "codec/tile_mesh.h"
#include "export/export_mesh.h"
#include "pyramid/report.h"
#include "pyramid/tile_extensions.h"
#include "simplify/simplifier.h"
#include "sink/output_options.h"

namespace qmesh {

/// One tile's file and what is to be told of it.
struct TileResult {
  std::vector<std::uint8_t> bytes; ///< as stored, compressed or not
  std::uint64_t fingerprint = 0;   ///< of the tile's name and uncompressed bytes
  LevelStats stats;
};

/// Makes tiles for one thread: height tile -> border -> TIN -> header -> bytes. The result is a
/// pure function of the height tile with its halo, the level and the options.
class TileJob {
 public:
  /// Takes compression and normals of `output`. Where the method is unknown every run() returns
  /// Code::usage with the names there are.
  TileJob(const MethodOptions& method, const OutputOptions& output);

  /// `kept`: the tiles of the tileset, for the metadata extension; null for a tile by itself. Adds
  /// to `seconds`.
  Status run(const HeightTile& tile, const LevelParams& level, const KeptTiles* kept,
             TileResult& result, StepSeconds& seconds);

  /// The same under --border inherit. `border`: in, the edges that neighbours have built, the
  /// others free; out, the edges of this tile (pyramid/inherited_border.h). The result depends on
  /// them, too.
  Status run(const HeightTile& tile, const LevelParams& level, const KeptTiles* kept,
             Border& border, TileResult& result, StepSeconds& seconds);

  /// The last tile made, for other programs. REQUIRES: `tile` is that tile.
  ExportMesh exportMesh(const HeightTile& tile) const;

 private:
  Status simplifyAndEncode(const HeightTile& tile, const LevelParams& level, const KeptTiles* kept,
                           TileResult& result, StepSeconds& seconds);
  void assemble(const HeightTile& tile, const KeptTiles* kept);
  void fillHeader(const GeoBox& box);

  Status made_; ///< of the simplifier
  std::unique_ptr<Simplifier> simplifier_;
  std::vector<std::unique_ptr<const ExtensionProvider>> extensions_;
  bool compress_;
  GzipCompressor gzip_;
  TileFrame frame_;
  Border border_;
  Tin tin_;
  TileMesh mesh_;
  std::vector<Vec3> positions_;
};

} // namespace qmesh
