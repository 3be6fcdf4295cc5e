// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "validate/finding.h"

namespace qmesh {

/// Counts findings by kind and keeps the first places of each.
class FindingCounts {
 public:
  struct Entry {
    std::uint64_t count = 0;
    Findings first;
  };

  /// `most`: places kept of a kind, 0: all. `ignored`: codes that are not wanted.
  FindingCounts(std::size_t most, std::set<int> ignored)
      : most_(most), ignored_(std::move(ignored)) {}

  void add(const Findings& findings);

  const std::map<int, Entry>& entries() const { return entries_; }
  /// Findings of a severity.
  std::uint64_t count(Severity severity) const;

 private:
  std::size_t most_;
  std::set<int> ignored_;
  std::map<int, Entry> entries_;
};

} // namespace qmesh
