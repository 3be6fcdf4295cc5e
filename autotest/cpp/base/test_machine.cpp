// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "base/machine.h"

namespace qmesh {
namespace {

TEST(Machine, MemoryIsAtMostWhatTheKernelCounts) {
  std::ifstream file("/proc/meminfo");
  std::string key;
  std::uint64_t kilobytes = 0;
  if (!(file >> key >> kilobytes) || key != "MemTotal:")
    GTEST_SKIP() << "this system has no /proc/meminfo to compare with";
  EXPECT_GT(machineMemoryBytes(), std::uint64_t{1} << 20);
  EXPECT_LE(machineMemoryBytes(), kilobytes * 1024);
}

} // namespace
} // namespace qmesh
