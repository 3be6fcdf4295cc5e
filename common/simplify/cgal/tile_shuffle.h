// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tiling/scheme.h"

namespace qmesh {

/// Pseudo-random numbers that are a pure function of the seed on every machine: SplitMix64 (Steele,
/// Lea & Flood, "Fast splittable pseudorandom number generators", 2014).
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_;
};

/// Puts values into an order that depends on the tile's name alone (Fisher & Yates), promise P3.
/// std::shuffle differs between libraries, and CGAL's random choices take no seed.
template <class T> void shuffleByTile(TileId tile, std::vector<T>& values) {
  SplitMix64 random((std::uint64_t(tile.z) << 58) ^ (std::uint64_t(tile.x) << 29) ^ tile.y);
  for (std::size_t left = values.size(); left > 1; --left)
    std::swap(values[left - 1], values[random.next() % left]);
}

} // namespace qmesh
