// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/assignment.h"
#include "options/build_options.h"
#include "options/option_table.h"

namespace qmesh {

/// A command line of any program, not yet written into its options.
struct ParsedWords {
  Request request = Request::run;
  std::vector<Assignment> assignments; ///< the configuration file's first
  std::vector<std::string> warnings;   ///< sentences without "warning:"; for the caller to print
};

/// Reads the words after the program's name: options and their values in any order with the
/// arguments, "--name value", "--name=value", "-x value", "-x5"; "--no-NAME" for a flag; "--" ends
/// the options. A configuration file it names is read and overridden by the command line.
/// Code::usage with one sentence where something is unknown or malformed.
Result<ParsedWords> parseWords(const OptionTable& table, const std::vector<std::string>& words);

/// A command line of gdal2qmesh, understood.
struct CommandLine {
  Request request = Request::run;
  BuildOptions options;              ///< complete and checked where request is run
  std::vector<std::string> warnings; ///< sentences without "warning:"; for the caller to print
};

/// parseWords() for gdal2qmesh, checked: Code::usage also where options contradict or INPUT is
/// missing.
Result<CommandLine> parseCommandLine(const OptionTable& table,
                                     const std::vector<std::string>& words);

/// The folder used where no OUTPUT is given: the input's base name without extension. Empty where
/// the input has none or is that name itself.
std::string defaultOutput(const std::string& input);

} // namespace qmesh
