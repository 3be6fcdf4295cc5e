// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <string>

namespace qmesh {

/// How the work is done. The tiles do not depend on it.
struct RunOptions {
  std::string configFile; ///< already read when a parser returns
  int threads = 0;        ///< 0: all processors
  std::uint64_t memoryBytes = 512ull << 20;
  int blockTiles = 0; ///< 2, 4 or 8; 0: by memory and threads
  bool dryRun = false;
  bool quiet = false;
  bool verbose = false;
};

} // namespace qmesh
