// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/assignment.h"

namespace qmesh {

Status applyAssignments(const std::vector<Assignment>& assignments, const OptionStructs& options) {
  for (const Assignment& assignment : assignments) {
    const OptionRow& row = *assignment.row;
    const Status status = row.set(options, assignment.value);
    if (status.ok())
      continue;
    const std::string reason = row.refusal.empty() ? "" : "; " + row.refusal;
    return Status(status.code(), assignment.place + ": " + status.message() + reason);
  }
  return {};
}

Status unknownOption(const OptionTable& table, const std::string& written,
                     const std::string& name) {
  const std::string closest = table.closestName(name);
  const std::string cure =
      closest.empty() ? "; --help lists all options" : "; did you mean --" + closest + "?";
  return Status(Code::usage, "unknown option " + written + cure);
}

} // namespace qmesh
