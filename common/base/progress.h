// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>

namespace qmesh {

/// Told how much is done, 0..1, never less than before; returns false to stop the work. Called from
/// the thread that started the work only.
using Progress = std::function<bool(double done)>;

} // namespace qmesh
