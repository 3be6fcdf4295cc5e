// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <mutex>
#include <unistd.h>

#include "codec/decode.h"
#include "codec/gzip.h"
#include "options/build_options.h"
#include "pyramid/tileset_builder.h"

namespace qmesh::synthetic {

/// Hills of a few sizes, metres; a function of the position alone.
inline double hills(double lon, double lat) {
  const double r = 0.017453292519943295;
  return 900 * std::sin(3 * lon * r) * std::cos(2 * lat * r) +
         300 * std::sin(40 * lon * r) * std::sin(31 * lat * r) +
         40 * std::sin(400 * lon * r + lat) * std::cos(290 * lat * r);
}

/// A DEM that is a formula. Voids: where `isVoid` says so.
class Source : public NodeSourceFactory {
 public:
  std::vector<GeoBox> boxes;
  int zoom = 4;
  std::function<bool(double lon, double lat)> isVoid = [](double, double) { return false; };
  mutable std::atomic<std::uint64_t> sampled{0}; ///< nodes asked for

  const std::vector<GeoBox>& extent() const override { return boxes; }
  int nativeZoom(const Scheme&, int) const override { return zoom; }
  double poleHeight(bool north) const override {
    for (const GeoBox& b : boxes) {
      if (north ? b.north >= 90 : b.south <= -90)
        return north ? 120 : -75;
    }
    return NAN;
  }
  Result<bool> hasData() const override { return true; }
  std::size_t bytesPerSource() const override { return 1 << 16; }
  Result<std::unique_ptr<NodeSource>> open(const NodeLattice& lattice) const override {
    return std::unique_ptr<NodeSource>(new Nodes(*this, lattice));
  }

  float height(double lon, double lat) const {
    for (const GeoBox& b : boxes) {
      const double east = lon < b.west ? lon + 360 : lon;
      if (east >= b.west && east <= b.east && lat >= b.south && lat <= b.north) {
        return isVoid(lon, lat) ? NAN : float(hills(lon, lat));
      }
    }
    return NAN;
  }

 private:
  class Nodes : public NodeSource {
   public:
    Nodes(const Source& source, const NodeLattice& lattice) : source_(source), lattice_(lattice) {}
    Status sample(std::int64_t i0, std::int64_t j0, int width, int height, float* out,
                  std::ptrdiff_t stride) override {
      source_.sampled += std::uint64_t(width) * std::uint64_t(height);
      for (int b = 0; b < height; ++b) {
        for (int a = 0; a < width; ++a) {
          out[b * stride + a] =
              source_.height(lattice_.longitude(i0 + a), lattice_.latitude(j0 + b));
        }
      }
      return {};
    }

   private:
    const Source& source_;
    NodeLattice lattice_;
  };
};

/// A set in memory.
class Sink : public TileSink {
 public:
  std::map<std::string, std::vector<std::uint8_t>> files;
  bool committed = false;
  bool abandoned = false;
  int failAfter = -1; ///< tiles until writing fails; -1: never

  Sink() {
    std::string name = testing::TempDir() + "qmesh-build-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~Sink() override { rmdir(folder_.c_str()); }

  static std::string nameOf(TileId t) {
    return std::to_string(t.z) + "/" + std::to_string(t.x) + "/" + std::to_string(t.y);
  }
  Status writeTile(TileId tile, const std::vector<std::uint8_t>& bytes) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failAfter == 0)
      return {Code::output, "full"};
    if (failAfter > 0)
      --failAfter;
    EXPECT_TRUE(files.emplace(nameOf(tile), bytes).second) << nameOf(tile) << " written twice";
    return {};
  }
  Status writeFile(const std::string& name, const std::string& text) override {
    files[name].assign(text.begin(), text.end());
    return {};
  }
  Status commit(const std::string& layerJson) override {
    committed = true;
    return writeFile("layer.json", layerJson);
  }
  void abandon() override { abandoned = true; }
  const std::string& scratch() const { return folder_; }

 private:
  std::mutex mutex_;
  std::string folder_;
};

inline BuildOptions smallOptions() {
  BuildOptions options;
  options.input.path = "formula";
  options.output.path = "memory";
  options.tiling.tileSize = 8;
  options.output.compression = Compression::none;
  return options;
}

/// Builds and expects success.
inline BuildReport build(const BuildOptions& options, const Source& source, Sink& sink,
                         const std::function<void(BlockPlan&)>& change = {}) {
  const auto plan = planPyramid(options, source);
  EXPECT_TRUE(plan.ok()) << plan.status().message();
  auto blocks = planBlocks(options, options.run, *plan, source.bytesPerSource(), 1);
  EXPECT_TRUE(blocks.ok()) << blocks.status().message();
  if (change)
    change(*blocks);
  auto report = buildTileset({options, *plan, source}, *blocks, {sink, sink.scratch()}, {});
  EXPECT_TRUE(report.ok()) << report.status().message();
  return *report;
}

} // namespace qmesh::synthetic
