// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <vector>

#include "options/option_row.h"

namespace qmesh {

/// Every row there is, in the order of the help; `methods` are the choices of --method.
std::vector<OptionRow> optionRows(const std::vector<Choice>& methods);

} // namespace qmesh
