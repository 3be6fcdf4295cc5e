// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "pyramid/tiling_options.h"
#include "simplify/method_options.h"
#include "sink/output_options.h"
#include "source/height_options.h"
#include "source/input_options.h"

namespace qmesh {

/// The options that decide what a tileset is: a view, which lives no longer than they do.
struct TilesetOptions {
  const InputOptions& input; ///< named in messages and in layer.json; a source has read the rest
  const HeightOptions& heights;
  const TilingOptions& tiling;
  const MethodOptions& method;
  const OutputOptions& output;
};

} // namespace qmesh
