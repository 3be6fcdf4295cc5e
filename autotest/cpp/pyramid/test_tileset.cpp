// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <set>

#include "border/border.h"
#include "codec/layer_json.h"
#include "synthetic.h"

namespace qmesh {
namespace {

using synthetic::Sink;
using synthetic::Source;

struct Globe : Source {
  Globe() {
    boxes = {{-180, -90, 180, 90}};
    zoom = 3;
  }
};

TileMesh decoded(const Sink& sink, TileId id) {
  const auto found = sink.files.find(Sink::nameOf(id));
  EXPECT_NE(found, sink.files.end()) << Sink::nameOf(id);
  auto mesh = decodeTile(found->second.data(), found->second.size());
  EXPECT_TRUE(mesh.ok()) << mesh.status().message();
  return *mesh;
}

/// Along-edge position, height in metres and normal of an edge's vertices.
struct EdgeVertex {
  int position;
  double height;
  int normal;
};
std::vector<EdgeVertex> edgeOf(const TileMesh& mesh, int edge) {
  std::vector<EdgeVertex> list;
  for (const std::uint32_t k : mesh.edges[std::size_t(edge)]) {
    const double t = mesh.q[k] / 32767.0;
    const double h = mesh.header.minHeight * (1 - t) + mesh.header.maxHeight * t;
    const bool alongV = edge == kWest || edge == kEast;
    list.push_back({alongV ? mesh.v[k] : mesh.u[k], h,
                    mesh.extensions.normals[2 * k] << 8 | mesh.extensions.normals[2 * k + 1]});
  }
  std::sort(list.begin(), list.end(),
            [](const EdgeVertex& a, const EdgeVertex& b) { return a.position < b.position; });
  return list;
}

void expectNoSeam(const TileMesh& a, int edgeA, const TileMesh& b, int edgeB) {
  const auto left = edgeOf(a, edgeA);
  const auto right = edgeOf(b, edgeB);
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t k = 0; k < left.size(); ++k) {
    EXPECT_EQ(left[k].position, right[k].position);
    EXPECT_NEAR(left[k].height, right[k].height, 1e-3);
    EXPECT_EQ(left[k].normal, right[k].normal);
  }
}

TEST(Tileset, WholeGlobeWithoutASeam) {
  for (const auto profile : {Profile::geodetic, Profile::mercator}) {
    BuildOptions options = synthetic::smallOptions();
    options.tiling.profile = profile;
    Sink sink;
    const BuildReport report = synthetic::build(options, Globe(), sink);
    const Scheme scheme(profile == Profile::geodetic ? Profile::geodetic : Profile::mercator);
    for (int z = 0; z <= 3; ++z) {
      const std::uint32_t columns = scheme.tilesX(z);
      for (std::uint32_t x = 0; x < columns; ++x) {
        for (std::uint32_t y = 0; y < scheme.tilesY(z); ++y) {
          const TileMesh mesh = decoded(sink, {z, x, y});
          expectNoSeam(mesh, kEast, decoded(sink, {z, (x + 1) % columns, y}), kWest);
          if (y > 0)
            expectNoSeam(mesh, kSouth, decoded(sink, {z, x, y - 1}), kNorth);
        }
      }
      EXPECT_LE(report.levels[std::size_t(z)].maxError, report.maxErrors[std::size_t(z)]);
    }
  }
}

TEST(Tileset, EveryNodeIsSampledOnce) {
  const Globe source;
  Sink sink;
  BuildOptions options = synthetic::smallOptions();
  options.run.blockTiles = 8;
  synthetic::build(options, source, sink);
  // 16 x 8 tiles of 8 cells at zoom 3, in two blocks with 11 nodes of halo.
  const std::uint64_t nodes = 128 * 65;
  EXPECT_GE(source.sampled, nodes);
  EXPECT_LE(source.sampled, nodes * 3 / 2 + 66 * 24);
}

TEST(Tileset, PolesHaveOneHeight) {
  Sink sink;
  synthetic::build(synthetic::smallOptions(), Globe(), sink);
  for (int z = 0; z <= 3; ++z) {
    for (std::uint32_t x = 0; x < (2u << z); ++x) {
      for (const EdgeVertex& v : edgeOf(decoded(sink, {z, x, (1u << z) - 1}), kNorth)) {
        EXPECT_NEAR(v.height, 120, 1e-3);
      }
      for (const EdgeVertex& v : edgeOf(decoded(sink, {z, x, 0}), kSouth)) {
        EXPECT_NEAR(v.height, -75, 1e-3);
      }
    }
  }
}

TEST(Tileset, LayerJsonListsExactlyTheFiles) {
  Source source;
  source.boxes = {{-30, -20, 40, 30}};
  source.zoom = 6;
  source.isVoid = [](double lon, double lat) { return lon > 0 && lat < 10; };
  for (const bool exclude : {false, true}) {
    BuildOptions options = synthetic::smallOptions();
    options.tiling.excludeVoid = exclude;
    Sink sink;
    synthetic::build(options, source, sink);
    const auto& text = sink.files.at("layer.json");
    const auto layer = readLayerJson(std::string(text.begin(), text.end()));
    ASSERT_TRUE(layer.ok()) << layer.status().message();
    std::set<std::string> listed;
    for (std::size_t z = 0; z < layer->available.size(); ++z) {
      for (const TileRange& r : layer->available[z]) {
        for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
          for (std::uint32_t x = r.x0; x <= r.x1; ++x) {
            listed.insert(Sink::nameOf({int(z), x, y}));
            if (z > 0) {
              EXPECT_TRUE(listed.count(Sink::nameOf({int(z) - 1, x / 2, y / 2})));
            }
          }
        }
      }
    }
    EXPECT_TRUE(listed.count("0/0/0") && listed.count("0/1/0"));
    EXPECT_EQ(listed.size() + 1, sink.files.size());
    for (const std::string& name : listed)
      EXPECT_TRUE(sink.files.count(name)) << name;
    // 25 x 18 tiles of zoom 6 meet the box; a tile of the void quarter is left out with -x.
    EXPECT_EQ(listed.count("6/70/28"), exclude ? 0u : 1u);
  }
}

TEST(Tileset, BridgedVoidsAreSmooth) {
  Source source;
  source.boxes = {{0, 0, 45, 45}};
  source.zoom = 5;
  source.isVoid = [](double lon, double lat) { return std::hypot(lon - 22, lat - 22) < 5; };
  BuildOptions options = synthetic::smallOptions();
  options.method.name = "delaunay";
  options.heights.voidFill = VoidFill::interpolate;
  Sink sink;
  synthetic::build(options, source, sink);
  // Inside the hole heights lie within the range around it, far from a fill of 0 - 1000 m below.
  const TileMesh mesh = decoded(sink, {5, 35, 19});
  const double low = mesh.header.minHeight, high = mesh.header.maxHeight;
  EXPECT_GT(low, -1300);
  EXPECT_LT(high, 1300);
  EXPECT_GT(high - low, 1);
}

TEST(Tileset, InterruptAndFailureAbandonTheSink) {
  const Globe source;
  const BuildOptions options = synthetic::smallOptions();
  const auto plan = planPyramid(options, source);
  const auto blocks = planBlocks(options, options.run, *plan, source.bytesPerSource(), 2);
  Sink failing;
  failing.failAfter = 5;
  auto report = buildTileset({options, *plan, source}, *blocks, {failing, failing.scratch()}, {});
  EXPECT_EQ(report.status().code(), Code::output);
  EXPECT_TRUE(failing.abandoned);
  EXPECT_FALSE(failing.committed);

  Sink stopped;
  report = buildTileset({options, *plan, source}, *blocks, {stopped, stopped.scratch()},
                        [](double) { return false; });
  EXPECT_EQ(report.status().code(), Code::interrupted);
  EXPECT_TRUE(stopped.abandoned);
  EXPECT_FALSE(stopped.committed);
}

TEST(Tileset, ProgressNeverGoesBack) {
  for (const auto fill : {VoidFill::value, VoidFill::interpolate}) {
    BuildOptions options = synthetic::smallOptions();
    options.heights.voidFill = fill;
    const Globe source;
    const auto plan = planPyramid(options, source);
    const auto blocks = planBlocks(options, options.run, *plan, source.bytesPerSource(), 2);
    Sink sink;
    double last = 0;
    const auto report =
        buildTileset({options, *plan, source}, *blocks, {sink, sink.scratch()}, [&](double done) {
          EXPECT_GE(done, last);
          EXPECT_LE(done, 1);
          last = done;
          return true;
        });
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(last, 1);
  }
}

} // namespace
} // namespace qmesh
