// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "base/text.h"
#include "tiling/level_spec.h"
#include "tiling/scheme.h"

namespace qmesh {
namespace {

/// A SPEC and its values as "ZOOM=VALUE ...", VALUE "-" where the zoom has none.
struct Case {
  const char* spec;
  const char* values;
};

class GoodSpec : public testing::TestWithParam<Case> {};

TEST_P(GoodSpec, HasItsValues) {
  const Result<LevelSpec> spec = LevelSpec::parse(GetParam().spec);
  ASSERT_TRUE(spec.ok()) << GetParam().spec << ": " << spec.status().message();
  const std::string values = GetParam().values;
  for (const std::string_view piece : split(values, ' ')) {
    const std::vector<std::string_view> sides = split(piece, '=');
    const Result<double> value = spec->at(static_cast<int>(*parseInteger(sides[0])));
    EXPECT_EQ(value.ok() ? formatNumber(*value) : "-", std::string(sides[1]))
        << GetParam().spec << " at " << piece;
    if (!value.ok()) {
      EXPECT_EQ(value.status().code(), Code::usage);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    LevelSpec, GoodSpec,
    testing::Values(Case{"5", "0=5 7=5 24=5 25=- -1=-"},                                  //
                    Case{"0", "0=0 24=0"},                                                //
                    Case{" 5 ", "0=5"},                                                   //
                    Case{"1e3", "3=1000"},                                                //
                    Case{"1e-3", "3=0.001"},                                              //
                    Case{"100/2^z", "0=100 1=50 2=25 3=12.5"}, Case{"100 / 2^z", "1=50"}, //
                    Case{"3*2^z", "0=3 1=6 10=3072"},                                     //
                    Case{"5,3,1", "0=5 1=3 2=1 3=1 24=1"},                                //
                    Case{"5 , 3", "0=5 1=3 2=3"},                                         //
                    Case{"0:5", "0=5 1=-"},                                               //
                    Case{"3-7:5", "2=- 3=5 7=5 8=-"},                                     //
                    Case{"8-:5", "7=- 8=5 24=5"},                                         //
                    Case{"0:9,3-7:2,8-:1", "0=9 1=- 3=2 7=2 8=1 24=1"},
                    Case{"8-:1,0-7:2", "0=2 7=2 8=1"}, //
                    Case{"0-3:80/2^z,4-:5*2^z", "0=80 3=10 4=80 5=160"},
                    Case{" 0 - 3 : 80 / 2^z , 4 - : 5", "3=10 4=5"}, Case{"0-24:1", "0=1 24=1"}, //
                    Case{"1e-3,2", "0=0.001 1=2"},                                               //
                    Case{"0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,7", "23=0 24=7"}));

class BadSpec : public testing::TestWithParam<const char*> {};

TEST_P(BadSpec, IsAUsageError) {
  const Result<LevelSpec> spec = LevelSpec::parse(GetParam());
  ASSERT_FALSE(spec.ok()) << GetParam();
  EXPECT_EQ(spec.status().code(), Code::usage);
  EXPECT_FALSE(spec.status().message().empty());
}

INSTANTIATE_TEST_SUITE_P(LevelSpec, BadSpec,
                         testing::Values("", " ", ",", "5,", ",5", "5,,3", "five", "5m", "-5",
                                         "-0:5", "nan", "inf", "1e999", "1e308*2^z", "5/2^",
                                         "5/2^x", "5/3^z", "5+2^z", "/2^z", "2^z", "5/2^z/2^z",
                                         "5/2^z,3", "3,5/2^z", ":5", "0:", "0:5,3", "5,0:3",
                                         "0-:5,3:2", "0-3:5,3-4:2", "7-3:5", "25:5", "0-25:5",
                                         "-3:5", "0--3:5", "1-2-3:5", "0:5:6", "a:5", "0.5:1",
                                         "0:5;1:2", "0:-1",
                                         "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,7"));

TEST(LevelSpec, FaultsAreNamed) {
  EXPECT_NE(LevelSpec::parse("5,x7,3").status().message().find("'x7'"), std::string::npos);
  EXPECT_NE(LevelSpec::parse("0:5,9-2:3").status().message().find("9-2"), std::string::npos);
  const std::string gap = LevelSpec::parse("0-3:5")->at(4).status().message();
  EXPECT_NE(gap.find("zoom 4"), std::string::npos) << gap;
}

/// Random specs by ranges, written by the test, against values the test works out itself.
TEST(LevelSpec, RandomRangesMatchATable) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  for (int round = 0; round < 2000; ++round) {
    std::array<double, kMaxZoom + 1> table;
    table.fill(-1);
    std::string text;
    for (int zoom = static_cast<int>(random() % 4); zoom <= kMaxZoom;) {
      const int last = std::min<int>(zoom + static_cast<int>(random() % 6), kMaxZoom);
      const double value = static_cast<double>(random() % 100000) / 64;
      const int exponent = static_cast<int>(random() % 3) - 1;
      for (int z = zoom; z <= last; ++z)
        table[static_cast<std::size_t>(z)] = value * std::pow(2.0, exponent * z);
      const std::string range = zoom == last ? std::to_string(zoom)
                                : last == kMaxZoom
                                    ? std::to_string(zoom) + "-"
                                    : std::to_string(zoom) + "-" + std::to_string(last);
      const char* formulas[] = {"/2^z", "", "*2^z"};
      text +=
          (text.empty() ? "" : ",") + range + ":" + formatNumber(value) + formulas[exponent + 1];
      zoom = last + 1 + static_cast<int>(random() % 3);
    }
    const Result<LevelSpec> spec = LevelSpec::parse(text);
    ASSERT_TRUE(spec.ok()) << text << ": " << spec.status().message() << ", seed " << kSeed;
    for (int z = 0; z <= kMaxZoom; ++z) {
      const Result<double> value = spec->at(z);
      ASSERT_EQ(value.ok() ? *value : -1, table[static_cast<std::size_t>(z)])
          << text << " at " << z;
    }
  }
}

/// Any text gives an answer; what is accepted has values that are finite and not negative.
TEST(LevelSpec, AnyTextIsAnswered) {
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  const std::string letters = "0123456789.,:-/*^2z e+x ";
  int accepted = 0;
  for (int round = 0; round < 50000; ++round) {
    std::string text(1 + random() % 9, ' ');
    for (char& c : text)
      c = letters[random() % letters.size()];
    const Result<LevelSpec> spec = LevelSpec::parse(text);
    if (!spec.ok())
      continue;
    ++accepted;
    for (int z = 0; z <= kMaxZoom; ++z) {
      const Result<double> value = spec->at(z);
      if (value.ok()) {
        ASSERT_TRUE(std::isfinite(*value) && *value >= 0) << text;
      }
    }
  }
  EXPECT_GT(accepted, 100);
}

} // namespace
} // namespace qmesh
