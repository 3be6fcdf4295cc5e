// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

namespace qmesh {

/// What a program's option struct derives from, so that one table, parser, help and JSON serve all
/// programs: a row gets the struct its program's rows are for.
struct OptionValues {};

} // namespace qmesh
