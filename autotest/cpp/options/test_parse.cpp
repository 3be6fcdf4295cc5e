// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "base/text.h"
#include "options/parse.h"
#include "options/validate.h"
#include "test_table.h"

namespace qmesh {
namespace {

/// A command line in one text, words between blanks.
Result<CommandLine> parse(const std::string& line) {
  std::vector<std::string> words;
  for (const std::string_view word : split(line, ' '))
    if (!word.empty())
      words.emplace_back(word);
  return parseCommandLine(testTable(), words);
}

BuildOptions options(const std::string& line) {
  const Result<CommandLine> parsed = parse(line);
  EXPECT_TRUE(parsed.ok()) << line << ": " << parsed.status().message();
  return parsed.ok() ? parsed->options : BuildOptions();
}

/// A command line and rows it sets, "NAME=VALUE NAME=VALUE", '_' for a blank in a value.
struct Case {
  const char* line;
  const char* rows;
};

class GoodLine : public testing::TestWithParam<Case> {};

TEST_P(GoodLine, SetsItsRows) {
  const BuildOptions parsed = options(GetParam().line);
  const std::string rows = GetParam().rows;
  for (const std::string_view piece : split(rows, ' ')) {
    const std::size_t equals = piece.find('=');
    std::string value(piece.substr(equals + 1));
    for (char& c : value)
      if (c == '_')
        c = ' ';
    const OptionRow* row = testTable().byName(piece.substr(0, equals));
    ASSERT_NE(row, nullptr) << piece;
    EXPECT_EQ(row->get(parsed), value) << GetParam().line;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Parse, GoodLine,
    testing::Values(Case{"dem.tif", "input=dem.tif output=dem zoom="},
                    Case{"dem.tif out", "input=dem.tif output=out"},
                    Case{"dem.tif -z 2-5 out -x", "output=out zoom=2-5 exclude=on"},
                    Case{"-z2-5 -j4 a.tif", "zoom=2-5 num-threads=4"},
                    Case{"-a -32768 a.tif", "srcnodata=-32768"},
                    Case{"-a-32768 a.tif", "srcnodata=-32768"},
                    Case{"--srcnodata=-1e10 a.tif", "srcnodata=-10000000000"},
                    Case{"--clip-low -100 --clip-high -.5 a.tif", "clip-low=-100 clip-high=-0.5"},
                    Case{"--te -120 30 -110 40 a.tif out",
                         "te=-120_30_-110_40 input=a.tif output=out"},
                    Case{"--te=-120,30,-110,40 a.tif", "te=-120_30_-110_40"},
                    Case{"--s-srs EPSG:1 a.tif", "s_srs=EPSG:1"}, //
                    Case{"--s_srs=EPSG:1 a.tif", "s_srs=EPSG:1"}, //
                    Case{"--max_error 5 a.tif", "max-error=5"},   //
                    Case{"--processes 3 a.tif", "num-threads=3"}, //
                    Case{"--no-normals a.tif", "normals=off"},    //
                    Case{"--no-normals --normals a.tif", "normals=on"},
                    Case{"--normals=off a.tif", "normals=off"},                 //
                    Case{"--xyz -q -v --overwrite --dry-run a.tif",             //
                         "xyz=on quiet=on verbose=on overwrite=on dry-run=on"}, //
                    Case{"--oo A=1 --oo=B=2 a.tif", "oo=A=1,_B=2"},             //
                    Case{"-b 2 -b 3 a.tif", "band=3"},                          //
                    Case{"-r near a.tif", "resampling=nearest"},                //
                    Case{"-d -p mercator a.tif", "profile=mercator"},           //
                    Case{"--min-zoom 2 --max-zoom 4 a.tif", "zoom=2-4"},        //
                    Case{"-z 2-9 --max-zoom 4 a.tif", "zoom=2-4"},              //
                    Case{"--max-zoom 4 -z 2- a.tif", "zoom=2-"},                //
                    Case{"-t --x -- -odd.tif --out", "title=--x input=-odd.tif output=--out"},
                    Case{"--title=--overwrite a.tif", "title=--overwrite overwrite=off"},
                    Case{"-w cesium --cesium dir a.tif", "webviewer=cesium cesium=dir"},
                    Case{"--max-error 0-3:5 -z 1-3 a.tif", "max-error=0-3:5"}));

/// A command line that is refused and a part of what is said about it.
class BadLine : public testing::TestWithParam<Case> {};

TEST_P(BadLine, IsAUsageError) {
  const Result<CommandLine> parsed = parse(GetParam().line);
  ASSERT_FALSE(parsed.ok()) << GetParam().line;
  EXPECT_EQ(parsed.status().code(), Code::usage);
  EXPECT_NE(parsed.status().message().find(GetParam().rows), std::string::npos)
      << GetParam().line << ": " << parsed.status().message();
}

INSTANTIATE_TEST_SUITE_P(Parse, BadLine,
                         testing::Values(Case{"", "INPUT"},        //
                                         Case{"-z 2-5", "INPUT"},  //
                                         Case{"a.tif b c", "'c'"}, //
                                         Case{"dem", "OUTPUT"},    //
                                         Case{"--max-eror 5 a.tif", "did you mean --max-error?"},
                                         Case{"--res near a.tif", "did you mean --resampling?"},
                                         Case{"-te 1 2 3 4 a.tif", "did you mean --te?"},     //
                                         Case{"--nonsense a.tif", "--help"},                  //
                                         Case{"--input a.tif", "unknown option --input"},     //
                                         Case{"-qv a.tif", "unknown option -qv"},             //
                                         Case{"-y a.tif", "unknown option -y"},               //
                                         Case{"--no-band a.tif", "unknown option --no-band"}, //
                                         Case{"--no-help a.tif", "unknown option --no-help"}, //
                                         Case{"--no-normals=on a.tif", "takes no value"},     //
                                         Case{"a.tif -b", "-b needs a value"},                //
                                         Case{"-t -x a.tif", "-t needs a value"},             //
                                         Case{"-t --overwrite a.tif", "-t needs a value"},    //
                                         Case{"--title --no-normals a.tif", "needs a value"}, //
                                         Case{"--te 1 2 3 -x a.tif", "needs 4 values"},       //
                                         Case{"--te 1 2 3", "needs 4 values"},                //
                                         Case{"--te 1 2 3 a.tif", "four numbers"},            //
                                         Case{"-p raster a.tif", "globe"},                    //
                                         Case{"-p raster a.tif", "expected geodetic or mercator"},
                                         Case{"-w leaflet a.tif", "none, cesium or all"}, //
                                         Case{"-b 0 a.tif",
                                              "-b 0: expected a whole number, 1 or more"},
                                         Case{"--overwrite=perhaps a.tif", "on or off"},  //
                                         Case{"-z 25 a.tif", "0 to 24"},                  //
                                         Case{"--max-error 5,x a.tif", "'x'"},            //
                                         Case{"--min-zoom 5 --max-zoom 3 a.tif", "zoom"}, //
                                         Case{"--min-x 5 --max-x 3 a.tif", "--min-x"},    //
                                         Case{"--min-y 5 --max-y 3 a.tif", "--min-y"},    //
                                         Case{"--clip-low 5 --clip-high 3 a.tif", "--clip-low"},
                                         Case{"--max-error 0-3:5 -z 0-5 a.tif", "zoom 4"}, //
                                         Case{"--screen-error 1-:5 a.tif", "zoom 0"},      //
                                         Case{"--te-srs EPSG:1 a.tif", "--te"},            //
                                         Case{"--config-file no/such/file a.tif", "no/such/file"}));

TEST(Parse, Requests) {
  EXPECT_EQ(parse("--help")->request, Request::help);
  EXPECT_EQ(parse("-h")->request, Request::briefHelp);
  EXPECT_EQ(parse("a.tif b --version --nonsense")->request, Request::version);
  EXPECT_EQ(parse("--options-json")->request, Request::optionsJson);
  EXPECT_EQ(parse("a.tif")->request, Request::run);
}

TEST(Parse, OptionsWithoutEffectWarn) {
  const Result<CommandLine> parsed = parse("-k -n -g KEY a.tif");
  ASSERT_TRUE(parsed.ok());
  ASSERT_EQ(parsed->warnings.size(), 3u);
  EXPECT_EQ(parsed->warnings[0].find("-k has no effect"), 0u);
  EXPECT_EQ(parsed->warnings[2].find("-g KEY has no effect"), 0u);
  EXPECT_TRUE(parse("-d a.tif")->warnings.empty());
}

TEST(Parse, OddPairsWarn) {
  EXPECT_NE(parse("-z 3-5 a.tif")->warnings.at(0).find("zoom 0"), std::string::npos);
  EXPECT_NE(parse("--cesium x a.tif")->warnings.at(0).find("--cesium"), std::string::npos);
  EXPECT_TRUE(parse("-z 0-5 -w all --cesium x a.tif")->warnings.empty());
}

TEST(Parse, OptionsOfOtherMethodsWarn) {
  BuildOptions options;
  const auto warnings = [&] {
    std::vector<std::string> said;
    EXPECT_TRUE(validate(options, said).ok());
    return said;
  };
  options.method.decimate = false;
  EXPECT_TRUE(warnings().empty());
  options.method.edgeCount = LevelSpec(100);
  options.method.featureAngle = 90;
  ASSERT_EQ(warnings().size(), 2u);
  EXPECT_EQ(warnings()[0].find("--edge-count has no effect with --method greedy"), 0u);
  options.method.name = "collapse";
  EXPECT_EQ(warnings().size(), 2u); // --decimate and --feature-angle
  for (const char* method : {"grid", "random", "hierarchy", "wlop"}) {
    options.method.name = method;
    EXPECT_EQ(warnings().size(), 2u) << method; // --decimate and --edge-count
  }
  options.compare.enabled = true;
  EXPECT_TRUE(warnings().empty());
}

TEST(Parse, MaxErrorMakesScreenErrorIrrelevant) {
  EXPECT_TRUE(parse("--max-error 5 --screen-error 1-:5 a.tif").ok());
}

TEST(Parse, DefaultOutput) {
  EXPECT_EQ(defaultOutput("dem.tif"), "dem");
  EXPECT_EQ(defaultOutput("/data/n34.w118.tif"), "n34.w118");
  EXPECT_EQ(defaultOutput("/vsizip/x.zip/a.hgt"), "a");
  EXPECT_EQ(defaultOutput("folder/arcgrid/"), "arcgrid");
  EXPECT_EQ(defaultOutput("dem"), "");
  EXPECT_EQ(defaultOutput("/"), "");
  EXPECT_EQ(defaultOutput(".."), "");
  EXPECT_EQ(defaultOutput("x/.hidden"), ".hidden");
}

/// A configuration file that goes with the test.
class ConfigOnDisk : public testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(path_) << text; }
  void TearDown() override { std::remove(path_.c_str()); }

  std::string path_ = testing::TempDir() + "qmesh_parse_test.conf";
};

TEST_F(ConfigOnDisk, CommandLineWins) {
  write("input = file.tif\nband = 2\nzoom = 1-7\noo = A=1\noo = B=2\noverwrite = on\nif = X\n");
  const BuildOptions parsed =
      options("--oo C=3 -b 5 --no-overwrite --max-zoom 3 --config-file " + path_);
  EXPECT_EQ(parsed.input.path, "file.tif");
  EXPECT_EQ(parsed.output.path, "file");
  EXPECT_EQ(parsed.input.band, 5);
  EXPECT_EQ(parsed.tiling.minZoom, 1);
  EXPECT_EQ(parsed.tiling.maxZoom, 3);
  EXPECT_EQ(parsed.input.openOptions, std::vector<std::string>{"C=3"});
  EXPECT_EQ(parsed.input.inputFormats, std::vector<std::string>{"X"});
  EXPECT_FALSE(parsed.output.overwrite);
}

TEST_F(ConfigOnDisk, FaultsNameFileAndLine) {
  write("# fine\nband = zero\n");
  const Result<CommandLine> parsed = parse("a.tif --config-file " + path_);
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.status().code(), Code::usage);
  EXPECT_EQ(parsed.status().message().find(path_ + ":2: band = zero: expected"), 0u)
      << parsed.status().message();
}

TEST_F(ConfigOnDisk, AFolderIsNoFile) {
  const Result<CommandLine> parsed = parse("a.tif --config-file " + testing::TempDir());
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.status().code(), Code::usage);
}

} // namespace
} // namespace qmesh
