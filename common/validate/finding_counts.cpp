// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/finding_counts.h"

namespace qmesh {

void FindingCounts::add(const Findings& findings) {
  for (const Finding& finding : findings) {
    if (ignored_.count(finding.code) > 0)
      continue;
    Entry& entry = entries_[finding.code];
    if (most_ == 0 || entry.count < most_)
      entry.first.push_back(finding);
    ++entry.count;
  }
}

std::uint64_t FindingCounts::count(Severity severity) const {
  std::uint64_t count = 0;
  for (const auto& [code, entry] : entries_)
    if (findingKind(code).severity == severity)
      count += entry.count;
  return count;
}

} // namespace qmesh
