// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "sink/sink_types.h"

#include <algorithm>

#include "sink/directory_sink.h"
#include "sink/zip_sink.h"

namespace qmesh {

const std::vector<SinkType>& sinkTypes() {
  static const std::vector<SinkType> types = {
      {"zip", isZipPath, openZipSink},
      {"folder", [](const std::string&) { return true; }, openDirectorySink},
  };
  return types;
}

Result<OpenedSink> openSink(const OutputOptions& options) {
  const auto& types = sinkTypes();
  const auto type = std::find_if(types.begin(), types.end(), [&](const SinkType& candidate) {
    return candidate.accepts(options.path);
  });
  return type->open(options);
}

} // namespace qmesh
