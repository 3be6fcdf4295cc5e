// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>

namespace qmesh {

/// Bytes of memory this machine (or the container around the process, where that has less) has;
/// 0 where it cannot be told.
std::uint64_t machineMemoryBytes();

} // namespace qmesh
