// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>

// A function with vector loops twice, for processors with and without AVX2. Both do the same
// operations in the same order, so they give the same bits. Sanitizers start up after the resolver
// of such a function has run, so with them there is the plain one only.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define QMESH_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define QMESH_VECTOR_CLONES
#endif

// What such a function calls must become part of it to get its instructions.
#define QMESH_INLINE [[gnu::always_inline]] inline

namespace qmesh {

/// Numbers that fill one 256-bit register, and the integers that go with them (vector extension of
/// GCC and Clang; works on any processor).
template <class Real> struct Lanes;

template <> struct Lanes<float> {
  static constexpr int kCount = 8;
  using Reals = float __attribute__((vector_size(32)));
  using HalfReals = float __attribute__((vector_size(16)));
  using Masks = std::int32_t __attribute__((vector_size(32))); ///< what a comparison gives
  using Ints = std::int32_t __attribute__((vector_size(32)));
};

template <> struct Lanes<double> {
  static constexpr int kCount = 4;
  using Reals = double __attribute__((vector_size(32)));
  using Masks = std::int64_t __attribute__((vector_size(32)));
  using Ints = std::int32_t __attribute__((vector_size(16)));
};

/// As many numbers behind the end of an array let the last of them be loaded as a lane.
inline constexpr int kLanePadding = 8;

} // namespace qmesh
