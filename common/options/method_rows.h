// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "options/option_row.h"

namespace qmesh {

/// The rows of MethodOptions, in the order of the help; `methods` are the choices of --method.
std::vector<OptionRow> methodRows(const std::vector<Choice>& methods);

} // namespace qmesh
