// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "sink/output_options.h"
#include "sink/tile_sink.h"

namespace qmesh {

/// A kind of output, chosen by its name.
struct SinkType {
  const char* name;
  /// Whether an output of that name is of this type.
  bool (*accepts)(const std::string& output);
  /// Checks the output before any work and makes it ready. Code::output with the reason and the
  /// cure.
  Result<OpenedSink> (*open)(const OutputOptions& options);
};

/// Every type; the first that accepts a name is taken, the last accepts all.
const std::vector<SinkType>& sinkTypes();

/// Opens the output of the options.
Result<OpenedSink> openSink(const OutputOptions& options);

} // namespace qmesh
