// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>

#include "simplify/simplifier.h"

namespace qmesh {

/// Greedy insertion (Garland & Heckbert 1995) in rounds, with the bounded decimation pass.
std::unique_ptr<Simplifier> createGreedy(const MethodOptions& options);

/// Edge collapse (Lindstrom & Turk 1998; Garland & Heckbert 1997) with CGAL; only in builds with
/// QMESH_WITH_CGAL.
std::unique_ptr<Simplifier> createCollapse(const MethodOptions& options);

/// Edge collapse by quadric errors (Garland & Heckbert 1997) down to the smallest visible object
/// (Ai et al. 2019).
std::unique_ptr<Simplifier> createQem(const MethodOptions& options);

/// Restricted quadtree by cumulated curvature or by the max error (Cifuentes, Venere & Clausse
/// 2010).
std::unique_ptr<Simplifier> createQuadtree(const MethodOptions& options);

/// Every node a vertex.
std::unique_ptr<Simplifier> createAllNodes(const MethodOptions& options);

} // namespace qmesh
