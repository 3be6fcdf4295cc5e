// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <random>

#include "options/config_file.h"
#include "test_table.h"

namespace qmesh {
namespace {

/// "NAME=VALUE;" of every assignment of a file, or the message of its fault.
std::string outcome(const std::string& text) {
  const Result<std::vector<Assignment>> assignments = parseConfig(testTable(), text, "f");
  if (!assignments.ok())
    return assignments.status().message();
  std::string joined;
  for (const Assignment& assignment : *assignments)
    joined += assignment.row->name + "=" + assignment.value + ";";
  return joined;
}

TEST(ConfigFile, Lines) {
  EXPECT_EQ(outcome(""), "");
  EXPECT_EQ(outcome("\n# all comments\n   # indented\n\n"), "");
  EXPECT_EQ(outcome("band = 2"), "band=2;");
  EXPECT_EQ(outcome("band=2\r\nzoom = 0-5\r\n"), "band=2;zoom=0-5;");
  EXPECT_EQ(outcome("\xEF\xBB\xBF"
                    "band = 2\n"),
            "band=2;");
  EXPECT_EQ(outcome("te = -120 30 -110 40"), "te=-120 30 -110 40;");
  EXPECT_EQ(outcome("oo = A=1\noo = B=2"), "oo=A=1;oo=B=2;");
  EXPECT_EQ(outcome("processes = 3"), "num-threads=3;");
  EXPECT_EQ(outcome("s-srs = EPSG:1"), "s_srs=EPSG:1;");
  EXPECT_EQ(outcome("tmscompatible = on"), "tmscompatible=on;");
}

TEST(ConfigFile, CommentsAndQuotes) {
  EXPECT_EQ(outcome("band = 2 # the second"), "band=2;");
  EXPECT_EQ(outcome("title = a#b"), "title=a#b;");
  EXPECT_EQ(outcome("title = \"a # b\" # c"), "title=a # b;");
  EXPECT_EQ(outcome("title = \"  \""), "title=  ;");
  EXPECT_EQ(outcome("title = \"\""), "title=;");
  EXPECT_EQ(outcome("title ="), "title=;");
  EXPECT_EQ(outcome("title = # nothing"), "title=;");
}

TEST(ConfigFile, FaultsHaveTheirLine) {
  EXPECT_EQ(outcome("band"), "f:1: expected 'name = value'");
  EXPECT_EQ(outcome("\n\nbannd = 2"), "f:3: unknown option 'bannd'; did you mean --band?");
  EXPECT_EQ(outcome("= 2").find("f:1: unknown option ''"), 0u);
  EXPECT_EQ(outcome("band = 2\nband = 3"), "f:2: band is set twice; keep one line");
  EXPECT_EQ(outcome("num-threads = 2\nprocesses = 3"),
            "f:2: num-threads is set twice; keep one line");
  EXPECT_EQ(outcome("title = \"open"), "f:1: expected one value in quotes");
  EXPECT_EQ(outcome("title = \"a\" b"), "f:1: expected one value in quotes");
  for (const char* name : {"config-file", "help", "version", "options-json"})
    EXPECT_EQ(outcome(std::string(name) + " = x"),
              "f:1: " + std::string(name) + " is allowed on the command line only");
}

/// Every row's default, written to a file and read back, changes nothing.
TEST(ConfigFile, DefaultsRoundTrip) {
  std::string text;
  for (const OptionRow& row : testTable().rows())
    if (!row.commandLineOnly && !row.defaultText().empty())
      text += row.name + " = " + row.defaultText() + "\n";
  const Result<std::vector<Assignment>> assignments = parseConfig(testTable(), text, "f");
  ASSERT_TRUE(assignments.ok()) << assignments.status().message();
  BuildOptions options;
  const Status status = applyAssignments(*assignments, options);
  ASSERT_TRUE(status.ok()) << status.message();
  for (const OptionRow& row : testTable().rows())
    EXPECT_EQ(row.get(options), row.defaultText()) << row.name;
}

TEST(ConfigFile, AnyBytesAreAnswered) {
  constexpr unsigned kSeed = 3;
  std::mt19937 random(kSeed);
  const std::string pieces[] = {
      "band", "=", "\"", "#", " ", "\n", "\r", "te", "1 2", "\xFF", std::string(1, '\0')};
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::size_t i = random() % 12; i > 0; --i)
      text += pieces[random() % std::size(pieces)];
    const Result<std::vector<Assignment>> assignments = parseConfig(testTable(), text, "f");
    if (!assignments.ok()) {
      ASSERT_EQ(assignments.status().message().find("f:"), 0u);
    }
  }
}

} // namespace
} // namespace qmesh
