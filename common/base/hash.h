// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace qmesh {

/// A 64-bit fingerprint of bytes, good against accidents, not against attackers: words are mixed
/// by xor and multiplication with a final avalanche (in the manner of MurmurHash3's fmix64).
/// The same on every little-endian machine.
inline std::uint64_t fingerprint(const void* data, std::size_t size, std::uint64_t seed) {
  constexpr std::uint64_t kPrime = 0x9e3779b97f4a7c15u;
  const auto* bytes = static_cast<const unsigned char*>(data);
  std::uint64_t hash = seed ^ (size * kPrime);
  for (std::size_t at = 0; at < size; at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + at, size - at < 8 ? size - at : 8);
    hash = (hash ^ word) * kPrime;
    hash ^= hash >> 29;
  }
  hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdu;
  return hash ^ (hash >> 33);
}

} // namespace qmesh
