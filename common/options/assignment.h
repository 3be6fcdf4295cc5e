// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/option_table.h"

namespace qmesh {

/// A value somebody gave to an option.
struct Assignment {
  const OptionRow* row = nullptr;
  std::string value;
  std::string place; ///< where it stands, for messages: "--band 0" or "my.conf:3: band = 0"
};

/// Writes the values into the fields of the program's structs, in order; Code::usage with the place
/// of the first bad one.
Status applyAssignments(const std::vector<Assignment>& assignments, const OptionStructs& options);

/// "unknown option 'NAME'" with the option it may have meant. `written`: as the user wrote it.
Status unknownOption(const OptionTable& table, const std::string& written, const std::string& name);

} // namespace qmesh
