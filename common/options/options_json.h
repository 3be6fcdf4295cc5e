// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "options/option_table.h"

namespace qmesh {

/// Every row as JSON, for programs that draw a form or a page:
///   {"program", "version", "groups": [{"name", "help"}],
///    "options": [{"name", "creationOption", "letter", "aliases", "group", "type", "placeholder",
///                 "unit", "minimum", "maximum", "choices": [{"name", "help"}], "default",
///                 "whenUnset", "help", "values", "position", "advanced", "repeatable",
///                 "commandLineOnly", "ignored"}]}
/// "default" is text as the option takes it; keys without content are left out. Ends with a line
/// end.
std::string optionsJson(const OptionTable& table, const std::string& version);

} // namespace qmesh
