// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "base/text.h"

namespace qmesh {
namespace {

constexpr unsigned kSeed = 20260101;

TEST(Text, NumbersComeBackBitForBit) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value))
      continue;
    const std::optional<double> back = parseNumber(formatNumber(value));
    ASSERT_TRUE(back) << formatNumber(value);
    ASSERT_EQ(*back, value) << "seed " << kSeed;
  }
}

TEST(Text, WholeNumbersHaveNoExponent) {
  EXPECT_EQ(formatNumber(0), "0");
  EXPECT_EQ(formatNumber(-100000), "-100000");
  EXPECT_EQ(formatNumber(1e14), "100000000000000");
  EXPECT_EQ(formatNumber(0.5), "0.5");
}

TEST(Text, NumbersAreTakenWholeOrNotAtAll) {
  EXPECT_EQ(parseNumber("-32768"), -32768);
  EXPECT_EQ(parseNumber("3e2"), 300);
  EXPECT_TRUE(std::isnan(*parseNumber("nan")));
  for (const char* bad : {"", " 1", "1 ", "1,5", "0x10", "1e", "--1", "1e999", "five", "1.5.2"})
    EXPECT_FALSE(parseNumber(bad)) << bad;
  EXPECT_EQ(parseInteger("-7"), -7);
  for (const char* bad : {"", "1.0", "9223372036854775808", "7 ", "1e3"})
    EXPECT_FALSE(parseInteger(bad)) << bad;
}

TEST(Text, Trimmed) {
  EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, JoinUndoesSplit) {
  std::mt19937 random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    std::string text(random() % 20, ' ');
    for (char& c : text)
      c = ",ab"[random() % 3];
    std::vector<std::string> pieces;
    for (const std::string_view piece : split(text, ','))
      pieces.emplace_back(piece);
    EXPECT_EQ(join(pieces, ","), text);
    for (const std::string& piece : pieces)
      EXPECT_EQ(piece.find(','), std::string::npos);
  }
}

TEST(Text, JsonStrings) {
  EXPECT_EQ(jsonString("a\"b\\c\n\t\r"), R"("a\"b\\c\n\t\r")");
  EXPECT_EQ(jsonString(std::string("\0\x1f\x7f", 3)), R"("\u0000\u001f\u007f")");
  EXPECT_EQ(jsonString("\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8C\x8D"),
            "\"\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8C\x8D\"");
}

TEST(Text, JsonStringsAreAlwaysUtf8) {
  // Overlong, surrogate, beyond U+10FFFF, cut short, a lone continuation byte.
  EXPECT_EQ(jsonString("\xC0\xAF"), R"("\ufffd\ufffd")");
  EXPECT_EQ(jsonString("\xE0\x80\xAF"), R"("\ufffd\ufffd\ufffd")");
  EXPECT_EQ(jsonString("\xED\xA0\x80"), R"("\ufffd\ufffd\ufffd")");
  EXPECT_EQ(jsonString("\xF4\x90\x80\x80"), R"("\ufffd\ufffd\ufffd\ufffd")");
  EXPECT_EQ(jsonString("\xE2\x82"), R"("\ufffd\ufffd")");
  EXPECT_EQ(jsonString("a\x80z"), R"("a\ufffdz")");
}

TEST(EscapeMarkup, LeavesNothingThatMarkupReads) {
  EXPECT_EQ(escapeMarkup("a < b & c > \"d\" 'e'"),
            "a &lt; b &amp; c &gt; &quot;d&quot; &apos;e&apos;");
  EXPECT_EQ(escapeMarkup("plain \xc3\xa9"), "plain \xc3\xa9");
}

TEST(Text, NumbersBelowAnEndAreDigitsAlone) {
  EXPECT_EQ(parseNumberBelow("0", 1), 0u);
  EXPECT_EQ(parseNumberBelow("41", 42), 41u);
  for (const char* text : {"42", "-1", "+1", " 1", "1 ", "", "1e1", "0x1", "99999999999999999999"})
    EXPECT_FALSE(parseNumberBelow(text, 42)) << text;
}

} // namespace
} // namespace qmesh
