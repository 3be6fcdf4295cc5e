// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdio>
#include <cstdlib>

namespace qmesh::fuzz {

/// Ends the program, which the fuzzer reports together with the input, where a promise is broken.
inline void require(bool kept, const char* promise) {
  if (kept)
    return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

} // namespace qmesh::fuzz
