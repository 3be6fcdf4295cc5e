// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "compare/compare_options.h"
#include "options/option_structs.h"
#include "pyramid/run_options.h"
#include "pyramid/tileset_options.h"

namespace qmesh {

/// The options of gdal2qmesh and of the driver's CreateCopy. Only those who run a build see all of
/// them; every module takes the structs it needs.
struct BuildOptions {
  InputOptions input;
  HeightOptions heights;
  TilingOptions tiling;
  MethodOptions method;
  OutputOptions output;
  RunOptions run;
  CompareOptions compare;

  operator TilesetOptions() const { return {input, heights, tiling, method, output}; } // NOLINT
  operator OptionStructs() {                                                           // NOLINT
    return OptionStructs::of(input, heights, tiling, method, output, run, compare);
  }
  operator ConstOptionStructs() const { // NOLINT
    return ConstOptionStructs::of(input, heights, tiling, method, output, run, compare);
  }
};

} // namespace qmesh
