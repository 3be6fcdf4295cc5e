// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// --border inherit: what a schedule's order one by one gives, however the work is cut.
#include <algorithm>

#include "grid/void_fill.h"
#include "pyramid/inherit/inherited_border.h"
#include "pyramid/inherit/schedule.h"
#include "pyramid/tile_job.h"
#include "synthetic.h"

namespace qmesh {
namespace {

using synthetic::Sink;
using synthetic::Source;

constexpr Schedule kSchedules[] = {Schedule::fourColour, Schedule::rowwise, Schedule::columnwise,
                                   Schedule::chessboard, Schedule::fourConnected};

bool speckle(double lon, double lat) {
  const double a = std::floor(lon * 3), b = std::floor(lat * 3);
  return std::fmod(std::abs(a * 7 + b * 13), 5) < 1 || (lon > 12 && lon < 25 && lat > 5);
}

bool choosesBorder(const std::string& method) {
  return findSimplifier(method)->create(MethodOptions())->choosesBorder();
}

void expectSameFiles(Sink& a, Sink& b, const std::string& what) {
  ASSERT_EQ(a.files.size(), b.files.size()) << what;
  for (const auto& file : a.files)
    ASSERT_EQ(b.files[file.first], file.second) << file.first << " differs: " << what;
}

struct Way {
  int blockTiles;
  int threads;
  bool spill;
};

void buildSo(BuildOptions options, const Source& source, const Way& way, Sink& sink) {
  options.run.blockTiles = way.blockTiles;
  options.run.threads = way.threads;
  synthetic::build(options, source, sink, [&](BlockPlan& blocks) {
    if (way.spill)
      blocks.storeBytes = 700;
  });
}

TEST(Inherit, EveryWayToCutTheWorkGivesTheSameBytes) {
  Source source;
  source.boxes = {{171.3, -12.1, 187.9, 9.7}}; // across the antimeridian
  source.zoom = 5;
  source.isVoid = speckle;
  for (const SimplifierInfo& method : simplifiers()) {
    for (const Schedule schedule : kSchedules) {
      for (const auto fill : {VoidFill::value, VoidFill::interpolate}) {
        BuildOptions options = synthetic::smallOptions();
        options.method.name = method.name;
        options.tiling.border = BorderMode::inherit;
        options.tiling.schedule = schedule;
        options.heights.voidFill = fill;
        options.tiling.excludeVoid = true;
        options.output.metadata = 2;
        Sink reference;
        buildSo(options, source, {8, 1, false}, reference);
        ASSERT_GT(reference.files.size(), 10u);
        for (const Way& way : {Way{2, 4, false}, Way{4, 2, true}}) {
          Sink sink;
          buildSo(options, source, way, sink);
          expectSameFiles(reference, sink, std::string(method.name) + " " + enumName(schedule));
        }
      }
    }
  }
}

/// Where no edge is free, inheriting gives what both tiles find by themselves.
TEST(Inherit, GivesTheSharedBordersOfMethodsThatDoNotChoose) {
  Source globe;
  globe.boxes = {{-180, -90, 180, 90}};
  globe.zoom = 3;
  globe.isVoid = speckle;
  for (const auto profile : {Profile::geodetic, Profile::mercator}) {
    for (const SimplifierInfo& method : simplifiers()) {
      if (choosesBorder(method.name))
        continue;
      for (const auto fill : {VoidFill::value, VoidFill::interpolate}) {
        BuildOptions options = synthetic::smallOptions();
        options.tiling.profile = profile;
        options.method.name = method.name;
        options.heights.voidFill = fill;
        options.tiling.minZoom = 1;
        options.tiling.excludeVoid = true;
        options.output.metadata = 2;
        Sink shared, inherited;
        synthetic::build(options, globe, shared);
        options.tiling.border = BorderMode::inherit;
        buildSo(options, globe, {4, 3, true}, inherited);
        expectSameFiles(shared, inherited, method.name);
      }
    }
  }
}

/// The tiles of one level in the order of the option's text, one by one, with a table of all edges.
class OneByOne {
 public:
  OneByOne(const BuildOptions& options, const PyramidPlan& plan, const Source& source)
      : options_(options), plan_(plan), source_(source), job_(options.method, options.output) {}

  std::map<std::string, std::vector<std::uint8_t>> run() {
    const int zoom = plan_.maxZoom;
    const TileSchedule order(plan_.scheme, zoom, plan_.tiles.ranges(zoom),
                             options_.tiling.schedule);
    std::vector<TileId> tiles(order.count());
    for (std::uint32_t k = 0; k < order.count(); ++k)
      tiles[order.rank(k)] = order.tile(k);
    for (const TileId id : tiles)
      make(id);
    return std::move(files_);
  }

 private:
  /// An edge by the places of its ends on the lattice of tile corners.
  using Name = std::array<std::uint32_t, 4>;
  Name nameOf(TileId id, Edge edge) const {
    const std::uint32_t columns = plan_.scheme.tilesX(id.z);
    const std::uint32_t x0 = id.x, x1 = (id.x + 1) % columns, y0 = id.y, y1 = id.y + 1;
    switch (edge) {
    case kWest:
      return {x0, y0, x0, y1};
    case kSouth:
      return {x0, y0, x1, y0};
    case kEast:
      return {x1, y0, x1, y1};
    case kNorth:
      break;
    }
    return {x0, y1, x1, y1};
  }

  void make(TileId id) {
    NodeWindow window;
    const NodeLattice lattice = plan_.lattice(id.z);
    window.reset(lattice, {id.x, id.y, id.x, id.y}, kTileHalo);
    const auto nodes = source_.open(lattice);
    const int first = window.firstExistingRow();
    ASSERT_TRUE((*nodes)
                    ->sample(window.column0(), window.row0() + first, window.width(),
                             window.endExistingRow() - first, window.row(first), window.stride())
                    .ok());
    window.setPoles(source_.poleHeight(false), source_.poleHeight(true));
    fillVoids(window, float(options_.heights.voidValue));
    Border border;
    for (const Edge edge : {kWest, kSouth, kEast, kNorth}) {
      const auto built = edges_.find(nameOf(id, edge));
      border.isFree[edge] = built == edges_.end();
      if (built != edges_.end())
        border[edge] = built->second;
    }
    TileResult result;
    StepSeconds seconds{};
    const LevelParams& level = plan_.levels[std::size_t(id.z)];
    ASSERT_TRUE(job_.run(window.tile(id), level, nullptr, border, result, seconds).ok());
    files_[Sink::nameOf(id)] = result.bytes;
    for (const Edge edge : {kWest, kSouth, kEast, kNorth})
      edges_[nameOf(id, edge)] = border[edge];
  }

  const BuildOptions& options_;
  const PyramidPlan& plan_;
  const Source& source_;
  TileJob job_;
  std::map<Name, std::vector<std::uint16_t>> edges_;
  std::map<std::string, std::vector<std::uint8_t>> files_;
};

TEST(Inherit, EqualsTheTilesMadeOneByOne) {
  Source globe;
  globe.boxes = {{-180, -90, 180, 90}};
  globe.zoom = 2;
  for (const SimplifierInfo& method : simplifiers()) {
    for (const Schedule schedule : kSchedules) {
      BuildOptions options = synthetic::smallOptions();
      options.method.name = method.name;
      options.tiling.border = BorderMode::inherit;
      options.tiling.schedule = schedule;
      options.tiling.minZoom = 2;
      options.tiling.maxZoom = 2;
      const auto plan = planPyramid(options, globe);
      ASSERT_TRUE(plan.ok());
      Sink sink;
      buildSo(options, globe, {2, 4, false}, sink);
      sink.files.erase("layer.json");
      EXPECT_EQ(sink.files, OneByOne(options, *plan, globe).run())
          << method.name << " " << enumName(schedule);
    }
  }
}

TEST(Inherit, StopsWhenTheUserSaysSo) {
  Source source;
  source.boxes = {{-30, -20, 40, 30}};
  BuildOptions options = synthetic::smallOptions();
  options.tiling.border = BorderMode::inherit;
  options.run.threads = 3;
  const auto plan = planPyramid(options, source);
  const auto blocks = planBlocks(options, options.run, *plan, source.bytesPerSource(), 1);
  Sink sink;
  const auto report = buildTileset({options, *plan, source}, *blocks, {sink, sink.scratch()},
                                   [](double) { return false; });
  // The run may be over before it is asked for the first time; then nothing is to be stopped.
  if (!report.ok()) {
    EXPECT_EQ(report.status().code(), Code::interrupted);
    EXPECT_TRUE(sink.abandoned);
  }
}

TEST(Inherit, AFullDiskIsSaid) {
  Source source;
  source.boxes = {{-30, -20, 40, 30}};
  BuildOptions options = synthetic::smallOptions();
  options.tiling.border = BorderMode::inherit;
  options.run.threads = 3;
  const auto plan = planPyramid(options, source);
  const auto blocks = planBlocks(options, options.run, *plan, source.bytesPerSource(), 1);
  Sink sink;
  sink.failAfter = 9;
  const auto report = buildTileset({options, *plan, source}, *blocks, {sink, sink.scratch()}, {});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.status().code(), Code::output);
  EXPECT_TRUE(sink.abandoned);
}

/// A method that chooses: what completeBorder leaves to it.
class Chooser : public Simplifier {
 public:
  bool choosesBorder() const override { return true; }
  Status simplify(const HeightTile&, const TileFrame&, const Border&, const LevelParams&,
                  Tin&) override {
    return {};
  }
};

TEST(CompleteBorder, FreesWhatAMethodMayChoose) {
  const std::vector<float> zeros(40 * 40, 0.f);
  const auto complete = [&](Profile profile, TileId id) {
    const NodeLattice lattice(Scheme(profile), id.z, 8);
    const HeightTile tile(id, lattice, zeros.data() + 10 * 40 + 10, 40);
    const LevelParams level = levelParams(Scheme(profile), id.z, 60000, 8);
    TileFrame frame;
    frame.reset(tile, level);
    Border border;
    border.isFree = {true, true, true, false};
    border[kNorth] = {0, 1234, 32767};
    completeBorder(Chooser(), tile, frame, level, border);
    EXPECT_EQ(border[kNorth], (std::vector<std::uint16_t>{0, 1234, 32767})); // inherited
    EXPECT_EQ(border[kWest].size(), std::size_t(level.baseGrid) + 1);
    return border.isFree;
  };
  using Free = std::array<bool, 4>;
  EXPECT_EQ(complete(Profile::geodetic, {3, 5, 4}), (Free{true, true, true, false}));
  EXPECT_EQ(complete(Profile::geodetic, {3, 5, 0}), (Free{true, false, true, false}));  // the pole
  EXPECT_EQ(complete(Profile::mercator, {0, 0, 0}), (Free{false, true, false, false})); // round
}

} // namespace
} // namespace qmesh
