// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>

#include "base/lru_cache.h"
#include "tileset/tileset.h"

namespace qmesh {

struct TileIdHash {
  std::size_t operator()(const TileId& tile) const {
    const std::uint64_t place = std::uint64_t(tile.y) << 32 | tile.x;
    return std::size_t((place * 32 + std::uint64_t(tile.z)) * 0x9e3779b97f4a7c15u >> 16);
  }
};

/// A decoded tile; null where the set has none.
using MeshPtr = std::shared_ptr<const TileMesh>;

/// The decoded tiles of a set that were asked for last. Serves one thread.
class TileCache {
 public:
  /// `set` must outlive the cache.
  explicit TileCache(const Tileset& set) : set_(&set), meshes_(kCapacity) {}

  const Tileset& set() const { return *set_; }

  /// Tiles the set cannot have are not looked for. Code::input for one that is damaged or cannot be
  /// read; that is not remembered.
  Result<MeshPtr> mesh(TileId tile);

  /// The first tile that is listed and was not there, empty when all were.
  const std::string& firstMissing() const { return firstMissing_; }

 private:
  static constexpr std::size_t kCapacity = std::size_t(32) << 20; ///< bytes

  const Tileset* set_;
  LruCache<TileId, MeshPtr, TileIdHash> meshes_;
  std::string firstMissing_;
};

/// Bytes a decoded tile takes.
std::size_t meshBytes(const TileMesh& mesh);

} // namespace qmesh
