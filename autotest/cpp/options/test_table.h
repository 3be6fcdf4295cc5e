// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "options/build_options.h"
#include "options/option_table.h"

namespace qmesh {

/// The option table with two methods, as the command has it.
inline const OptionTable& testTable() {
  static const OptionTable table({{"greedy", "inserts the worst node"}, {"delaunay", "all nodes"}});
  return table;
}

} // namespace qmesh
