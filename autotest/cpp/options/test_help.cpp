// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include "base/text.h"
#include "options/help.h"
#include "options/parse.h"
#include "test_table.h"

namespace qmesh {
namespace {

/// The text with every run of blanks and line ends as one blank, so that broken lines do not count.
std::string flowing(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank)
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  return result;
}

TEST(Help, HasEveryRow) {
  const std::string help = flowing(helpText(testTable()));
  const auto has = [&](const std::string& text) { return help.find(text) != std::string::npos; };
  for (const OptionRow& row : testTable().rows()) {
    EXPECT_TRUE(has(row.help)) << row.name;
    EXPECT_TRUE(has(row.placeholder)) << row.name;
    if (row.position != 0)
      continue;
    EXPECT_TRUE(has("--" + row.name) || has("--[no-]" + row.name)) << row.name;
    if (row.letter != 0) {
      EXPECT_TRUE(has(std::string("-") + row.letter + ", --" + row.name)) << row.name;
    }
    for (const std::string& alias : row.aliases)
      EXPECT_TRUE(has("--" + alias)) << alias;
    for (const Choice& choice : row.choices)
      EXPECT_TRUE(has(choice.name)) << row.name << " " << choice.name;
  }
}

TEST(Help, BriefShowsTheEssentialOptionsAndThreeExamples) {
  const std::string help = briefHelpText(testTable());
  int options = 0;
  for (const OptionRow& row : testTable().rows()) {
    const std::string text = flowing(help);
    const bool shown = text.find(" --" + row.name + " ") != std::string::npos ||
                       text.find(" --" + row.name + ",") != std::string::npos;
    EXPECT_TRUE(shown || !row.essential || row.position != 0) << row.name;
    options += row.essential && row.position == 0 ? 1 : 0;
  }
  EXPECT_GE(options, 12);
  EXPECT_LE(options, 16);
  int examples = 0;
  for (const std::string_view line : split(help, '\n'))
    examples += line.substr(0, 13) == "  gdal2qmesh " ? 1 : 0;
  EXPECT_EQ(examples, 3);
  EXPECT_NE(help.find("gdal2qmesh --help\n"), std::string::npos);
  EXPECT_LT(help.size(), helpText(testTable()).size() / 3);
}

TEST(Help, NamesTheMethodsOfARow) {
  const std::string help = flowing(helpText(testTable()));
  EXPECT_NE(help.find("[method collapse; 0 to 1;"), std::string::npos);
  EXPECT_NE(help.find("[methods grid, random, hierarchy, wlop;"), std::string::npos);
  EXPECT_NE(help.find("[method hierarchy; 0 to 1/3;"), std::string::npos);
}

TEST(Help, ShowsTheDefaults) {
  const std::string help = flowing(helpText(testTable()));
  for (const OptionRow& row : testTable().rows()) {
    if (row.type == OptionType::flag || row.position == 1 || row.values == 0 ||
        !row.ignored.empty())
      continue;
    const std::size_t sentence = help.find(row.help);
    const std::string value = row.defaultText().empty() ? row.whenUnset : row.defaultText();
    ASSERT_FALSE(value.empty()) << row.name << " must say its default";
    const std::size_t close = help.find(']', sentence + row.help.size());
    const std::string facts = help.substr(sentence + row.help.size(), close - sentence);
    EXPECT_NE(facts.find("default: " + value), std::string::npos) << row.name << ":" << facts;
  }
}

TEST(Help, LinesFitTheTerminal) {
  for (const int columns : {60, 72, 80, 100}) {
    const std::string help = helpText(testTable(), columns);
    for (const std::string_view line : split(help, '\n')) {
      if (line.find("  gdal2qmesh ") == 0)
        continue; // an example is copied as a whole
      EXPECT_LE(line.size(), static_cast<std::size_t>(columns)) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
  }
  const std::string usual = helpText(testTable());
  for (const std::string_view line : split(usual, '\n'))
    EXPECT_LE(line.size(), 80u) << line;
}

TEST(Help, ExamplesParse) {
  for (const Example& example : testTable().program().examples) {
    std::vector<std::string> words;
    for (const std::string_view word : split(example.command, ' '))
      words.emplace_back(word);
    ASSERT_EQ(words[0], "gdal2qmesh");
    words.erase(words.begin());
    const Result<CommandLine> line = parseCommandLine(testTable(), words);
    EXPECT_TRUE(line.ok()) << example.command << ": " << line.status().message();
    EXPECT_TRUE(line->warnings.empty()) << example.command;
  }
}

TEST(Help, TeachesSpecExitCodesAndMethods) {
  const std::string help = helpText(testTable());
  for (const char* text : {"V/2^z", "Exit codes", "3   stopped", "greedy: inserts the worst node",
                           "delaunay: all nodes", "usage: gdal2qmesh [options] INPUT [OUTPUT]"})
    EXPECT_NE(help.find(text), std::string::npos) << text;
}

} // namespace
} // namespace qmesh
