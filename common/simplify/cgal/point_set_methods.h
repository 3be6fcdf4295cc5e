// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <memory>

#include "simplify/simplifier.h"

namespace qmesh {

/// One node a cube of a grid in space.
std::unique_ptr<Simplifier> createGridPoints(const MethodOptions& options);

/// A share of the nodes, whichever.
std::unique_ptr<Simplifier> createRandomPoints(const MethodOptions& options);

/// One node a cluster, clusters divided by size and surface variation (Pauly, Gross & Kobbelt
/// 2002).
std::unique_ptr<Simplifier> createHierarchyPoints(const MethodOptions& options);

/// Nodes spread evenly by weighted locally optimal projection (Huang et al. 2009).
std::unique_ptr<Simplifier> createWlopPoints(const MethodOptions& options);

} // namespace qmesh
