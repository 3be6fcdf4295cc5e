// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>

#include "simplify/simplifier.h"

namespace qmesh {

/// Greedy insertion (Garland & Heckbert 1995) in rounds, with the bounded decimation pass.
std::unique_ptr<Simplifier> createGreedy(const MethodOptions& options);

/// Every node a vertex.
std::unique_ptr<Simplifier> createAllNodes(const MethodOptions& options);

} // namespace qmesh
