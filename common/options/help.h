// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/option_table.h"

namespace qmesh {

/// "usage: gdal2qmesh [options] INPUT [OUTPUT]", without a line end.
std::string usageLine(const OptionTable& table);

/// The text of --help: every row by group, the language of SPEC, examples and exit codes. Lines are
/// at most `columns` long, 60 at least, except where one word is longer.
std::string helpText(const OptionTable& table, int columns = 80);

/// The same with the options most people need and three examples, for -h.
std::string briefHelpText(const OptionTable& table, int columns = 80);

} // namespace qmesh
