// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/method_specs.h"

#include <cassert>

#include "base/text.h"

namespace qmesh {

namespace {

/// A value of one LevelSpec at every zoom, within its range.
Status checkSpec(const MethodSpec& row, const LevelSpec& spec, int first, int last) {
  const std::string option = std::string("--") + row.name + " " + spec.text() + ": ";
  for (int zoom = first; zoom <= last; ++zoom) {
    const Result<double> value = spec.at(zoom);
    if (!value.ok())
      return Status(value.status().code(), option + value.status().message());
    if (*value < row.minimum.value_or(0) || *value > row.maximum.value_or(*value))
      return Status(Code::usage, option + formatNumber(*value) + " at zoom " +
                                     std::to_string(zoom) + " is not " + row.rangeText());
  }
  return {};
}

} // namespace

std::string MethodSpec::rangeText() const {
  return qmesh::rangeText(minimum, maximum, unit);
}

const std::vector<MethodSpec>& methodSpecs() {
  using Options = MethodOptions;
  constexpr std::nullopt_t kOpen = std::nullopt;
  static const std::vector<MethodSpec> rows = {
      {"max-error", &Options::maxError, "m", kOpen, kOpen},
      {"screen-error", &Options::screenError, "px", kOpen, kOpen},
      {"init-grid", &Options::initGrid, "cells per tile edge", 1, 1024},
      {"edge-count", &Options::edgeCount, "edges", 5, kOpen},
      {"edge-ratio", &Options::edgeRatio, "", 0, 1},
      {"shape-weight", &Options::shapeWeight, "", 0, kOpen},
      {"svo", &Options::svo, "m", 0, kOpen},
      {"ratio", &Options::ratio, "", 0, 1},
      {"curvature", &Options::curvature, "", 0, kOpen},
      {"border-max-error", &Options::borderMaxError, "m", 0, kOpen},
      {"border-max-length", &Options::borderMaxLength, "% of the tile edge", 0.1, 100},
      {"cell-size", &Options::cellSize, "m", 1e-3, kOpen},
      {"random-percent", &Options::randomPercent, "%", 0, 100},
      {"cluster-size", &Options::clusterSize, "points", 1, kOpen},
      {"max-variance", &Options::maxVariance, "", 0, 1.0 / 3},
      {"retain-percent", &Options::retainPercent, "%", 0, 100},
      {"radius", &Options::radius, "m", 1e-3, kOpen},
  };
  return rows;
}

const MethodSpec& methodSpec(std::string_view name) {
  for (const MethodSpec& row : methodSpecs())
    if (row.name == name)
      return row;
  assert(false);
  return methodSpecs().front();
}

Status checkSpecs(const MethodOptions& options, int first, int last) {
  for (const MethodSpec& row : methodSpecs()) {
    const LevelSpec& spec = options.*row.field;
    const bool overridden = row.field == &MethodOptions::screenError && options.maxError.isSet();
    if (spec.isSet() && !overridden)
      QMESH_RETURN_IF_ERROR(checkSpec(row, spec, first, last));
  }
  return {};
}

} // namespace qmesh
