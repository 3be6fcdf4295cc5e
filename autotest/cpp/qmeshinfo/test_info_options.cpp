// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmeshinfo/info_options.h"

#include <gtest/gtest.h>

#include <set>

#include "options/help.h"
#include "options/options_json.h"

namespace qmesh {
namespace {

Result<InfoCommandLine> parse(const std::string& line) {
  std::vector<std::string> words;
  for (const std::string_view word : split(line, ' '))
    words.emplace_back(word);
  return parseInfoCommandLine(infoTable(), words);
}

TEST(InfoOptions, EveryRowReadsItsDefault) {
  const OptionTable table = infoTable();
  std::set<std::string> names;
  std::set<char> letters;
  for (const OptionRow& row : table.rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(row.letter == 0 || letters.insert(row.letter).second) << row.name;
    EXPECT_FALSE(row.help.empty()) << row.name;
    InfoOptions options;
    if (!row.defaultText().empty()) {
      EXPECT_TRUE(row.set(options, row.defaultText()).ok()) << row.name;
    }
    EXPECT_EQ(row.get(options), row.defaultText()) << row.name;
  }
}

TEST(InfoOptions, RowsSharedWithTheBuilderReachTheirFields) {
  const auto line =
      parse("--dem d.tif -s EPSG:32611 -b 2 -a -9999 --bathymetry -z 3-7 -j 2 -q set");
  ASSERT_TRUE(line.ok()) << line.status().message();
  const InfoOptions& options = line->options;
  EXPECT_EQ(options.set, "set");
  EXPECT_EQ(options.dem.path, "d.tif");
  EXPECT_EQ(options.dem.sourceSrs, "EPSG:32611");
  EXPECT_EQ(options.dem.band, 2);
  EXPECT_EQ(options.dem.sourceNodata, -9999);
  EXPECT_TRUE(options.heights.bathymetry);
  EXPECT_EQ(options.minZoom, 3);
  EXPECT_EQ(options.maxZoom, 7);
  EXPECT_EQ(options.run.threads, 2);
  EXPECT_TRUE(options.run.quiet);
}

TEST(InfoOptions, OwnOptionsReachTheirFields) {
  const auto line = parse("set --tile 4/3/2 --export a.PLY --frame ecef --draw b.svg --shade slope "
                          "--width 99 --sample -120.5,40 --ignore QM101 --ignore QM102");
  ASSERT_TRUE(line.ok()) << line.status().message();
  const InfoOptions& options = line->options;
  EXPECT_EQ(*options.tile, (TileId{4, 3, 2}));
  EXPECT_EQ(options.exportFile, "a.PLY");
  EXPECT_EQ(options.frame, MeshFrame::ecef);
  EXPECT_EQ(options.shade, MeshShade::slope);
  EXPECT_EQ(options.drawingWidth, 99);
  EXPECT_EQ(options.samples, std::vector<std::string>{"-120.5,40"});
  EXPECT_EQ(options.ignore.size(), 2u);
}

class BadInfoLine : public testing::TestWithParam<const char*> {};

TEST_P(BadInfoLine, IsAUsageError) {
  const auto line = parse(GetParam());
  ASSERT_FALSE(line.ok());
  EXPECT_EQ(line.status().code(), Code::usage);
  EXPECT_FALSE(line.status().message().empty());
}

INSTANTIATE_TEST_SUITE_P(Info, BadInfoLine,
                         testing::Values("--stats", "set more", "set --tile 1/2",
                                         "set --tile 1/2/x", "set --tile 25/0/0",
                                         "set --tile -1/0/0", "set --export a.obj",
                                         "set --tile 1/0/0 --export a.xyz",
                                         "set --tile 1/0/0 --draw a.jpg",
                                         "set --error-raster e.tif", "set --sample 1",
                                         "set --sample 1,91", "set --sample 1,2,3",
                                         "set --max-error 5", "set --width 1", "set --dem-step x"));

TEST(InfoOptions, PlacesMayBeSeparatedByBlanks) {
  EXPECT_EQ(*parseLonLat(" -98.5\t33 "), (std::array<double, 2>{-98.5, 33}));
  EXPECT_EQ(*parseLonLat("1,  2"), (std::array<double, 2>{1, 2}));
  EXPECT_FALSE(parseLonLat("nan,2").ok());
}

TEST(InfoOptions, HelpTellsThisProgram) {
  const std::string help = helpText(infoTable());
  EXPECT_EQ(help.substr(0, 37), "usage: qmeshinfo [options] TILESET\n\nD");
  EXPECT_EQ(help.find("SPEC:"), std::string::npos);
  EXPECT_EQ(help.find("Tiling:"), std::string::npos) << "a group without rows";
  EXPECT_NE(optionsJson(infoTable(), "1").find("\"program\": \"qmeshinfo\""), std::string::npos);
}

TEST(InfoOptions, EveryExampleParses) {
  const OptionTable table = infoTable();
  for (const Example& example : table.program().examples) {
    const auto line = parse(example.command.substr(std::string("qmeshinfo ").size()));
    EXPECT_TRUE(line.ok()) << example.command << ": " << line.status().message();
  }
}

} // namespace
} // namespace qmesh
