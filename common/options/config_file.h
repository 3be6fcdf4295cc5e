// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/assignment.h"

namespace qmesh {

/// The options of a configuration file: lines "name = value" with an option's long name. A flag's
/// value is on or off. A '#' at the start of a line or after a blank begins a comment; a value in
/// double quotes is taken as it stands. An option that is not repeatable may be set once.
/// Code::usage with "FILE:LINE" where a line is malformed, or where the file cannot be read.
Result<std::vector<Assignment>> readConfigFile(const OptionTable& table, const std::string& path);

/// The same from memory; `name` stands for the file in messages.
Result<std::vector<Assignment>> parseConfig(const OptionTable& table, const std::string& text,
                                            const std::string& name);

} // namespace qmesh
