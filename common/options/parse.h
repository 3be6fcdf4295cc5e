// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/option_table.h"

namespace qmesh {

/// A command line, understood.
struct CommandLine {
  Request request = Request::build;
  BuildOptions options;              ///< complete and checked where request is build
  std::vector<std::string> warnings; ///< sentences without "warning:"; for the caller to print
};

/// Reads the words after the program's name: options and their values in any order with INPUT and
/// OUTPUT, "--name value", "--name=value", "-x value", "-x5"; "--no-NAME" for a flag; "--" ends the
/// options. A configuration file it names is read first and overridden by the command line.
/// Code::usage with one sentence where something is unknown, malformed or contradicts.
Result<CommandLine> parseCommandLine(const OptionTable& table,
                                     const std::vector<std::string>& words);

/// The folder used where no OUTPUT is given: the input's base name without extension. Empty where
/// the input has none or is that name itself.
std::string defaultOutput(const std::string& input);

} // namespace qmesh
