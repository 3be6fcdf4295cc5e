// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/text.h"
#include "test_table.h"

namespace qmesh {
namespace {

/// Of one row: a value it takes, that value as the row writes it, and values it refuses.
struct RowCase {
  std::string good;
  std::string written;
  std::vector<std::string> bad;
};

const std::vector<std::string> kBadSwitch = {"", "2", "maybe"};
const std::vector<std::string> kBadHeight = {"", "high", "1e9", "-1e9", "nan", "inf", "5m"};
const std::vector<std::string> kBadZoom = {"", "-1", "25", "5.5", "all"};
const std::vector<std::string> kBadTile = {"", "-1", "33554432", "1.5", "x"};
const std::vector<std::string> kBadSpec = {"", "x", "-1", "5,", "0:5,0:6", "nan"};
const std::vector<std::string> kEmpty = {""};

/// Every row of the table with a field must be here: a test says so.
const std::map<std::string, RowCase>& rowCases() {
  static const std::map<std::string, RowCase> cases = {
      {"input", {"a b.tif", "a b.tif", kEmpty}},
      {"output", {"/vsis3/x/y", "/vsis3/x/y", kEmpty}},
      {"s_srs", {"EPSG:32611", "EPSG:32611", kEmpty}},
      {"band", {"3", "3", {"", "0", "-1", "1.5", "x", "99999999999"}}},
      {"srcnodata", {"-32768", "-32768", {"", "none", "1,2"}}},
      {"te",
       {"-120 30,-110.5 40",
        "-120 30 -110.5 40",
        {"", "1 2 3", "1 2 3 4 5", "1 2 3 x", "3 2 1 4", "1 4 3 2", "1 2 1 4", "1 2 inf 4",
         "nan 2 3 4"}}},
      {"te-srs", {"EPSG:4326", "EPSG:4326", kEmpty}},
      {"cutline", {"coast.gpkg", "coast.gpkg", kEmpty}},
      {"oo", {"A=B=C", "A=B=C", {"", "A", "=B"}}},
      {"if", {"GTiff", "GTiff", kEmpty}},
      {"bathymetry", {"on", "on", kBadSwitch}},
      {"clip-low", {"-100", "-100", kBadHeight}},
      {"clip-high", {"8848.86", "8848.86", kBadHeight}},
      {"scale-above", {"2.5", "2.5", {"", "-1", "nan", "x", "1e9"}}},
      {"scale-below", {"0", "0", {"", "-1", "inf", "x"}}},
      {"void-fill", {"interpolate", "interpolate", {"", "smooth", "value", "nan", "1e9"}}},
      {"profile", {"mercator", "mercator", {"", "raster", "EPSG:4326", "geo"}}},
      {"zoom", {"2-5", "2-5", {"", "-", "-5", "5-2", "25", "0-25", "a", "2-5-7", "2:5", "1.5"}}},
      {"min-zoom", {"24", "24", kBadZoom}},
      {"max-zoom", {"0", "0", kBadZoom}},
      {"min-x", {"33554431", "33554431", kBadTile}},
      {"max-x", {"5", "5", kBadTile}},
      {"min-y", {"0", "0", kBadTile}},
      {"max-y", {"6", "6", kBadTile}},
      {"tilesize", {"8", "8", {"", "0", "4", "100", "255", "2048", "-256", "64.0"}}},
      {"resampling", {"near", "nearest", {"", "mode", "bilinear2"}}},
      {"overview-resampling", {"cubic", "cubic", {"", "bilinear", "gauss"}}},
      {"exclude", {"YES", "on", kBadSwitch}},
      {"xyz", {"true", "on", kBadSwitch}},
      {"method", {"Delaunay", "delaunay", {"", "collapse", "greed"}}},
      {"max-error", {"100/2^z", "100/2^z", kBadSpec}},
      {"screen-error", {"0:1,1-:2", "0:1,1-:2", kBadSpec}},
      {"decimate", {"off", "off", kBadSwitch}},
      {"border", {"Inherit", "inherit", {"", "own"}}},
      {"schedule", {"Rowwise", "rowwise", {"", "random"}}},
      {"error-type", {"3d", "3d", {"", "2d"}}},
      {"init-grid", {"8,16", "8,16", kBadSpec}},
      {"edge-count", {"3000", "3000", kBadSpec}},
      {"edge-ratio", {"0.1", "0.1", kBadSpec}},
      {"cost", {"garland-heckbert", "garland-heckbert", {"", "x"}}},
      {"space", {"metric", "metric", {"", "x"}}},
      {"volume-weight", {"0.25", "0.25", {"", "-1", "x", "nan"}}},
      {"boundary-weight", {"1", "1", {"", "-1", "x", "inf"}}},
      {"shape-weight", {"0-9:1e-10,10-:0", "0-9:1e-10,10-:0", kBadSpec}},
      {"svo", {"1000/2^z", "1000/2^z", kBadSpec}},
      {"ratio", {"0.05", "0.05", kBadSpec}},
      {"curvature", {"0.5", "0.5", kBadSpec}},
      {"observer", {"7.5, 46", "7.5,46,0", {"", "1", "1,2,3,4", "181,0", "0,91", "a,b"}}},
      {"observer-range", {"500", "500", {"", "0", "-1", "x", "1e9"}}},
      {"border-max-error", {"5", "5", kBadSpec}},
      {"border-max-length", {"10", "10", kBadSpec}},
      {"feature-angle", {"45", "45", {"", "-1", "181", "x"}}},
      {"feature-min-size", {"3", "3", {"", "0", "1.5"}}},
      {"cell-size", {"100*2^z", "100*2^z", kBadSpec}},
      {"random-percent", {"95", "95", kBadSpec}},
      {"cluster-size", {"20", "20", kBadSpec}},
      {"max-variance", {"0.01", "0.01", kBadSpec}},
      {"retain-percent", {"5", "5", kBadSpec}},
      {"radius", {"300", "300", kBadSpec}},
      {"iterations", {"10", "10", {"", "0", "1.5", "1001"}}},
      {"normals", {"off", "off", kBadSwitch}},
      {"metadata", {"10", "10", {"", "-1", "25", "x"}}},
      {"compress", {"none", "none", {"", "zip"}}},
      {"overwrite", {"on", "on", kBadSwitch}},
      {"webviewer", {"cesium", "cesium", {"", "leaflet", "openlayers", "google"}}},
      {"cesium", {"Cesium-1.100", "Cesium-1.100", kEmpty}},
      {"title", {"A title", "A title", {}}},
      {"copyright", {"(c) X", "(c) X", {}}},
      {"report", {"r.json", "r.json", kEmpty}},
      {"num-threads", {"7", "7", {"", "0", "-1", "1025", "all", "1.5"}}},
      {"memory",
       {"2GB",
        "2GB",
        {"", "0", "-5", "lots", "GB", "%", "101%", "0%", "-1%", "1e30", "5XB", "nan", "inf",
         "0.5"}}},
      {"block-tiles", {"4", "4", {"", "0", "3", "16", "x"}}},
      {"config-file", {"c.conf", "c.conf", kEmpty}},
      {"dry-run", {"on", "on", kBadSwitch}},
      {"compare", {"on", "on", kBadSwitch}},
      {"compare-tile", {"10/544/718", "10/544/718", {"", "10/544", "a/b/c", "30/0/0"}}},
      {"debug-meshes", {"meshes", "meshes", kEmpty}},
      {"debug-format", {"obj", "obj", {"", "stl"}}},
      {"quiet", {"on", "on", kBadSwitch}},
      {"verbose", {"on", "on", kBadSwitch}},
  };
  return cases;
}

/// Rows that write into fields other rows write into as well.
const std::map<std::string, std::set<std::string>> kSharing = {
    {"zoom", {"min-zoom", "max-zoom"}}, {"min-zoom", {"zoom"}}, {"max-zoom", {"zoom"}}};

bool hasField(const OptionRow& row) {
  return row.request == Request::run && row.ignored.empty() && row.name != "tmscompatible";
}

TEST(Rows, EachHasACase) {
  std::set<std::string> names;
  for (const OptionRow& row : testTable().rows())
    if (hasField(row))
      names.insert(row.name);
  std::set<std::string> tested;
  for (const auto& [name, rowCase] : rowCases())
    tested.insert(name);
  EXPECT_EQ(names, tested);
}

TEST(Rows, NamesAndLettersAreUnique) {
  std::set<std::string> names;
  std::set<char> letters;
  std::set<std::string> creationOptions;
  for (const OptionRow& row : testTable().rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    for (const std::string& alias : row.aliases)
      EXPECT_TRUE(names.insert(alias).second) << alias;
    if (row.letter != 0) {
      EXPECT_TRUE(letters.insert(row.letter).second) << row.letter;
    }
    EXPECT_TRUE(creationOptions.insert(row.creationOption()).second) << row.name;
  }
}

TEST(Rows, EachSetsItsFieldAndNoOther) {
  for (const auto& [name, rowCase] : rowCases()) {
    const OptionRow* row = testTable().byName(name);
    ASSERT_NE(row, nullptr) << name;
    BuildOptions options;
    const Status status = row->set(options, rowCase.good);
    ASSERT_TRUE(status.ok()) << name << ": " << status.message();
    EXPECT_EQ(row->get(options), rowCase.written) << name;
    EXPECT_NE(row->get(options), row->defaultText()) << name << ": choose a case that differs";
    for (const OptionRow& other : testTable().rows()) {
      const auto sharing = kSharing.find(name);
      if (&other == row || (sharing != kSharing.end() && sharing->second.count(other.name)))
        continue;
      EXPECT_EQ(other.get(options), other.defaultText()) << name << " changed " << other.name;
    }
  }
}

TEST(Rows, EachReadsWhatItWrites) {
  for (const auto& [name, rowCase] : rowCases()) {
    const OptionRow* row = testTable().byName(name);
    BuildOptions options;
    ASSERT_TRUE(row->set(options, rowCase.written).ok()) << name;
    EXPECT_EQ(row->get(options), rowCase.written) << name;
    const std::string byDefault = row->defaultText();
    if (!byDefault.empty()) {
      EXPECT_TRUE(row->set(options, byDefault).ok()) << name << " " << byDefault;
    }
  }
}

TEST(Rows, EachRefusesBadValuesAndKeepsItsField) {
  for (const auto& [name, rowCase] : rowCases()) {
    const OptionRow* row = testTable().byName(name);
    for (const std::string& bad : rowCase.bad) {
      BuildOptions options;
      const Status status = row->set(options, bad);
      EXPECT_EQ(status.code(), Code::usage) << name << " took '" << bad << "'";
      EXPECT_FALSE(status.message().empty());
      EXPECT_EQ(row->get(options), row->defaultText()) << name;
    }
  }
}

TEST(Rows, RangesAreThoseTheReaderTakes) {
  for (const OptionRow& row : testTable().rows()) {
    if (row.type != OptionType::integer && row.type != OptionType::number)
      continue;
    BuildOptions options;
    for (const auto& [limit, step] : {std::pair(row.minimum, -1.0), std::pair(row.maximum, 1.0)}) {
      if (!limit)
        continue;
      EXPECT_TRUE(row.set(options, formatNumber(*limit)).ok()) << row.name;
      EXPECT_FALSE(row.set(options, formatNumber(*limit + step)).ok()) << row.name;
    }
  }
}

TEST(Rows, ChoicesAreThoseTheReaderTakes) {
  for (const OptionRow& row : testTable().rows())
    for (const Choice& choice : row.choices) {
      BuildOptions options;
      ASSERT_TRUE(row.set(options, choice.name).ok()) << row.name << " " << choice.name;
      EXPECT_EQ(row.get(options), choice.name) << row.name;
    }
}

TEST(Rows, DefaultsAreTheInitialisers) {
  const BuildOptions options;
  const auto text = [](const char* name) { return testTable().byName(name)->defaultText(); };
  EXPECT_EQ(text("band"), std::to_string(options.input.band));
  EXPECT_EQ(text("tilesize"), std::to_string(options.tiling.tileSize));
  EXPECT_EQ(text("method"), options.method.name);
  EXPECT_EQ(text("screen-error"), options.method.screenError.text());
  EXPECT_EQ(text("resampling"), enumName(options.input.resampling));
  EXPECT_EQ(text("normals"), options.output.normals ? "on" : "off");
  EXPECT_EQ(text("memory"), std::to_string(options.run.memoryBytes >> 20) + "MB");
  EXPECT_EQ(text("num-threads"), "ALL_CPUS");
  EXPECT_EQ(text("max-error"), "");
}

TEST(Rows, CreationOptionNames) {
  EXPECT_EQ(testTable().byName("max-error")->creationOption(), "MAX_ERROR");
  EXPECT_EQ(testTable().byName("s_srs")->creationOption(), "S_SRS");
}

TEST(Rows, Memory) {
  const OptionRow& row = *testTable().byName("memory");
  const auto bytes = [&](const char* text) {
    BuildOptions options;
    EXPECT_TRUE(row.set(options, text).ok()) << text;
    return options.run.memoryBytes;
  };
  EXPECT_EQ(bytes("1000"), 1000u);
  EXPECT_EQ(bytes("1000B"), 1000u);
  EXPECT_EQ(bytes("3K"), 3u << 10);
  EXPECT_EQ(bytes("512MB"), 512u << 20);
  EXPECT_EQ(bytes("512 mb"), 512u << 20);
  EXPECT_EQ(bytes("1.5GiB"), 3ull << 29);
  EXPECT_EQ(bytes("2T"), 2ull << 40);
  EXPECT_GT(bytes("40%"), bytes("20%"));
  EXPECT_NEAR(static_cast<double>(bytes("100%")), 2.0 * static_cast<double>(bytes("50%")), 2);
}

TEST(Rows, Zooms) {
  const OptionRow& row = *testTable().byName("zoom");
  BuildOptions options;
  ASSERT_TRUE(row.set(options, "10").ok());
  EXPECT_EQ(options.tiling.minZoom, 10);
  EXPECT_EQ(options.tiling.maxZoom, 10);
  ASSERT_TRUE(row.set(options, "3-").ok());
  EXPECT_EQ(options.tiling.minZoom, 3);
  EXPECT_FALSE(options.tiling.maxZoom);
  EXPECT_EQ(row.get(options), "3-");
}

TEST(Rows, VoidFill) {
  const OptionRow& row = *testTable().byName("void-fill");
  BuildOptions options;
  ASSERT_TRUE(row.set(options, "interpolate").ok());
  ASSERT_TRUE(row.set(options, "-12.5").ok());
  EXPECT_EQ(options.heights.voidFill, VoidFill::value);
  EXPECT_EQ(options.heights.voidValue, -12.5);
}

TEST(Rows, NodataMayBeNan) {
  BuildOptions options;
  ASSERT_TRUE(testTable().byName("srcnodata")->set(options, "nan").ok());
  EXPECT_NE(*options.input.sourceNodata, *options.input.sourceNodata);
}

} // namespace
} // namespace qmesh
