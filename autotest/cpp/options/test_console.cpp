// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <random>

#include "console/console.h"

namespace qmesh {
namespace {

const std::string kWhole = "0...10...20...30...40...50...60...70...80...90...100 - done.\n";

/// What a terminal shows of a text: "\r" goes back to the start of the line and writes over it.
std::string shown(const std::string& text) {
  std::string line;
  std::size_t column = 0;
  for (const char c : text) {
    if (c == '\r') {
      column = 0;
      continue;
    }
    if (column == line.size())
      line += ' ';
    line[column++] = c;
  }
  return line;
}

TEST(ProgressLine, PrintsTheSameForAnySteps) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> step(0, 0.2);
  for (int round = 0; round < 200; ++round) {
    ProgressLine line(false);
    std::string text;
    for (double done = 0; done < 1; done += step(random))
      text += line.update(done, 100 * done);
    EXPECT_TRUE(line.open());
    text += line.update(1, 100);
    EXPECT_FALSE(line.open());
    text += line.update(1, 101);
    ASSERT_EQ(text, kWhole) << "seed " << kSeed;
  }
}

TEST(ProgressLine, NeverGoesBack) {
  ProgressLine line(false);
  EXPECT_EQ(line.update(0.5, 1), "0...10...20...30...40...50");
  EXPECT_EQ(line.update(0.2, 2), "");
  EXPECT_EQ(line.update(7, 3), "...60...70...80...90...100 - done.\n");
}

TEST(ProgressLine, ATerminalShowsTheTimeLeft) {
  ProgressLine line(true);
  std::string text = line.update(0, 0);
  EXPECT_EQ(shown(text), "0");
  text += line.update(0.1, 10);
  EXPECT_EQ(shown(text), "0...10 1 min 30 s left");
  EXPECT_EQ(line.update(0.1, 10.5), "") << "not more than once a second";
  text += line.update(0.1, 20);
  EXPECT_EQ(shown(text), "0...10 3 min 00 s left");
  text += line.update(0.5, 30);
  EXPECT_EQ(shown(text).find("0...10...20...30...40...50 30 s left"), 0u) << shown(text);
  text += line.update(1, 60);
  EXPECT_EQ(shown(text), kWhole);
}

TEST(ProgressLine, AShorterLineWipesTheLongerOne) {
  ProgressLine line(true);
  std::string text = line.update(0.1, 1000);
  const std::size_t longest = shown(text).size();
  text += line.update(0.1, 1001.5);
  text += line.update(0.11, 1003);
  EXPECT_GE(shown(text).size(), longest);
  EXPECT_EQ(shown(text).find("left") + 4, shown(text).find_last_not_of(' ') + 1) << shown(text);
}

TEST(Console, Durations) {
  EXPECT_EQ(durationText(0), "0 s");
  EXPECT_EQ(durationText(11.2), "12 s");
  EXPECT_EQ(durationText(59.5), "1 min 00 s");
  EXPECT_EQ(durationText(3900), "1 h 05 min");
  EXPECT_EQ(durationText(-5), "0 s");
}

/// Runs `talk` on a console and returns what it said on stdout and stderr.
template <class Talk> std::pair<std::string, std::string> said(Talk talk) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Console console("gdal2qmesh");
  talk(console);
  std::string out = testing::internal::GetCapturedStdout();
  return {out, testing::internal::GetCapturedStderr()};
}

TEST(Console, MessagesBeginTheirOwnLine) {
  const auto [out, err] = said([](Console& console) {
    console.message("hello");
    console.detail("not verbose");
    console.progress(0.1);
    console.error("broken");
  });
  EXPECT_EQ(out, "hello\n0...10\n");
  EXPECT_EQ(err, "gdal2qmesh: error: broken\n");
}

TEST(Console, QuietLeavesErrorsOnly) {
  const auto [out, err] = said([](Console& console) {
    console.setQuiet(true);
    console.setVerbose(true);
    console.message("hello");
    console.detail("detail");
    console.warning("careful");
    console.progress(1);
    console.usageError("usage: x", "broken");
  });
  EXPECT_EQ(out, "");
  EXPECT_EQ(err, "usage: x\ngdal2qmesh: error: broken\n");
}

TEST(Console, ColumnsWithoutATerminal) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(Console("gdal2qmesh").columns(), 80);
  testing::internal::GetCapturedStdout();
}

} // namespace
} // namespace qmesh
