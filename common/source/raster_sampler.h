// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "source/interpolator.h"
#include "source/node_positions.h"
#include "source/node_source.h"
#include "source/raster_input.h"
#include "source/region.h"

namespace qmesh {

/// What is done to heights after interpolation.
struct HeightRules {
  double scaleAbove = 1, scaleBelow = 1;   ///< above / below sea level; first
  std::optional<double> clipLow, clipHigh; ///< metres; then

  bool none() const { return scaleAbove == 1 && scaleBelow == 1 && !clipLow && !clipHigh; }
  float apply(float height) const;
};

/// All that samplers of one input have in common; const while they live.
struct SamplerSetup {
  RasterInput input;
  HeightRules heights;
  std::vector<Region> regions; ///< a node must be in each
  GeoBox extent;               ///< of the raster, with a margin
  Resampling resampling = Resampling::bilinear;
};

/// Samples one raster on one lattice.
class RasterSampler : public NodeSource {
 public:
  /// `setup` must outlive the sampler. `antialias`: stretch the kernel where nodes are further
  /// apart than pixels.
  static Result<std::unique_ptr<RasterSampler>> open(std::shared_ptr<const SamplerSetup> setup,
                                                     const NodeLattice& lattice,
                                                     Resampling resampling, bool antialias);

  Status sample(std::int64_t i0, std::int64_t j0, int width, int height, float* out,
                std::ptrdiff_t stride) override;

  /// Reads pixels until one has a height; false when none has.
  static Result<bool> anyHeight(const RasterInput& input);

  /// Bytes a sampler takes at most.
  static std::size_t bytes();

 private:
  RasterSampler(std::shared_ptr<const SamplerSetup> setup, const NodeLattice& lattice,
                DatasetPtr dataset, std::unique_ptr<NodePositions> positions, PixelReader reader,
                Interpolator interpolator, const PixelFrame& frame);

  Status sampleWindow(const NodeRectangle& window, float* out, std::ptrdiff_t stride);
  bool pixelRectangle(const PixelBounds& bounds, PixelWindow& pixels) const;
  void finishRow(const NodeRectangle& window, int row, float* heights);

  std::shared_ptr<const SamplerSetup> setup_;
  NodeLattice lattice_;
  DatasetPtr dataset_;
  std::unique_ptr<NodePositions> positions_;
  PixelReader reader_;
  Interpolator interpolator_;
  PixelFrame frame_; ///< of the level that is read
  PixelWindow pixels_;
  std::vector<double> x_, y_, longitudes_;
};

} // namespace qmesh
