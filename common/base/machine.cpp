// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "base/machine.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace qmesh {

namespace {

/// The limit a control group sets, or `otherwise` where there is none ("max") or no such file.
std::uint64_t limitIn(const char* path, std::uint64_t otherwise) {
  std::uint64_t limit = 0;
  std::ifstream file(path);
  return file >> limit ? limit : otherwise;
}

} // namespace

std::uint64_t machineMemoryBytes() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long pageSize = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || pageSize <= 0)
    return 0;
  std::uint64_t bytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageSize);
  // Version 2 and version 1 of Linux' control groups, as a container sees its own.
  for (const char* path :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
    bytes = std::min(bytes, limitIn(path, bytes));
  return bytes;
}

} // namespace qmesh
