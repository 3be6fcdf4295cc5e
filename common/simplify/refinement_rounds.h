// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "simplify/node_heights.h"
#include "simplify/triangulation.h"

namespace qmesh {

/// A node to insert and the triangle it is the worst of.
struct Candidate {
  std::uint64_t order; ///< largest error first, then smallest node
  std::int32_t node;
  std::int32_t triangle;

  bool operator<(const Candidate& o) const { return order < o.order; }
};

inline Candidate makeCandidate(const NodeError& worst, std::int32_t triangle) {
  std::uint32_t bits = 0; // those of floats >= 0 are in the order of their values
  std::memcpy(&bits, &worst.error, sizeof bits);
  return {std::uint64_t(~bits) << 32 | std::uint32_t(worst.node), worst.node, triangle};
}

/// Greedy insertion in rounds: all changed triangles are scanned, their worst nodes sorted, and
/// those go in whose triangle is still the one that was scanned.
class RefinementRounds {
 public:
  /// Until there is nothing to insert. `scan(triangle)` gives the NodeError to cure, `insert` takes
  /// a Candidate and says whether it went in. True when any node did.
  template <class Scan, class Insert> bool run(Triangulation& mesh, Scan scan, Insert insert) {
    bool any = false;
    while (!mesh.changed().empty()) {
      scanList_.swap(mesh.changed());
      mesh.changed().clear();
      candidates_.clear();
      for (const std::int32_t t : scanList_) {
        mesh.clearChanged(t);
        const NodeError worst = scan(t);
        if (worst.node >= 0)
          candidates_.push_back(makeCandidate(worst, t));
      }
      std::sort(candidates_.begin(), candidates_.end());
      for (const Candidate& candidate : candidates_) {
        if (!mesh.isChanged(candidate.triangle) && insert(candidate))
          any = true;
      }
    }
    return any;
  }

 private:
  std::vector<Candidate> candidates_;
  std::vector<std::int32_t> scanList_;
};

} // namespace qmesh
