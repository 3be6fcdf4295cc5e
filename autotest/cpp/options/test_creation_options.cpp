// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include "options/creation_options.h"
#include "test_table.h"

namespace qmesh {
namespace {

std::string faultOf(const std::vector<std::string>& pairs) {
  const auto parsed = parseCreationOptions(testTable(), pairs);
  return parsed.ok() ? "" : parsed.status().message();
}

TEST(CreationOptions, ReadsPairsInAnyCase) {
  const auto parsed =
      parseCreationOptions(testTable(), {"MAX_ERROR=5", "tilesize=64", "Title=a=b", "PROCESSES=2"});
  ASSERT_TRUE(parsed.ok()) << parsed.status().message();
  BuildOptions options;
  ASSERT_TRUE(applyAssignments(*parsed, options).ok());
  EXPECT_EQ("5", options.method.maxError.text());
  EXPECT_EQ(64, options.tiling.tileSize);
  EXPECT_EQ("a=b", options.output.title);
  EXPECT_EQ(2, options.run.threads);
}

TEST(CreationOptions, WhatIsNotOursIsPassedOver) {
  const auto parsed = parseCreationOptions(
      testTable(), {"@ANYTHING=1", "QUIET_DELETE_ON_CREATE_COPY=NO", "append_subdataset=YES"});
  ASSERT_TRUE(parsed.ok());
  EXPECT_TRUE(parsed->empty());
}

TEST(CreationOptions, FaultsNameTheCure) {
  EXPECT_EQ("unknown creation option MAX_EROR; did you mean MAX_ERROR?", faultOf({"MAX_EROR=1"}));
  EXPECT_EQ("unknown creation option ZZZZ; gdalinfo --format QMESH lists all", faultOf({"ZZZZ=1"}));
  EXPECT_EQ("BAND is not a creation option; use -b of gdal_translate", faultOf({"BAND=1"}));
  EXPECT_EQ("QUIET is an option of gdal2qmesh, not of the driver", faultOf({"QUIET=YES"}));
  EXPECT_EQ("creation option 'XYZ': expected NAME=VALUE", faultOf({"XYZ"}));
  EXPECT_EQ("XYZ=YES and xyz=NO contradict; keep one", faultOf({"XYZ=YES", "xyz=NO"}));
  EXPECT_EQ("", faultOf({"XYZ=YES", "xyz=YES"}));
}

TEST(CreationOptions, SentencesOfTheCommandLineInTheDriversWords) {
  const auto words = [](const std::string& text) { return inCreationWords(testTable(), text); };
  EXPECT_EQ("MAX_ERROR is", words("--max-error is"));
  EXPECT_EQ("NORMALS=NO (VOID_FILL, -a_nodata)", words("--no-normals (--void-fill, -a)"));
  EXPECT_EQ("MIN_X/MAX_X leave", words("--min-x/--max-x leave"));
  EXPECT_EQ("in a/-s/b-s", words("in a/-s/b-s"));
  EXPECT_EQ("give it with -a_srs, as -a_srs EPSG:4326", words("give it with -s, as -s EPSG:4326"));
  EXPECT_EQ("gdal_translate -a_ullr 1 -2 --nothing a-b",
            words("gdal_translate -a_ullr 1 -2 --nothing a-b"));
}

TEST(CreationOptions, XmlHasEveryRowOfTheDriverOnce) {
  const std::string xml = creationOptionXml(testTable());
  for (const OptionRow& row : testTable().rows()) {
    const std::string mark = "<Option name='" + row.creationOption() + "' ";
    EXPECT_EQ(row.isCreationOption(), xml.find(mark) != std::string::npos) << row.name;
  }
  EXPECT_EQ(std::string::npos, xml.find("--")) << "a word of the command line";
  EXPECT_NE(std::string::npos, xml.find("alias='PROCESSES'"));
}

TEST(CreationOptions, XmlIsEscaped) {
  OptionRow row = *testTable().byName("title");
  row.help = "a < b & 'c' \"d\" > e";
  const OptionTable table = OptionTable::of(testTable().program(), {row});
  EXPECT_NE(std::string::npos,
            creationOptionXml(table).find("a &lt; b &amp; &apos;c&apos; &quot;d&quot; &gt; e"));
}

} // namespace
} // namespace qmesh
