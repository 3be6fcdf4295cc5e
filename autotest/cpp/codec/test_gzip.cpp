// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/gzip.h"

#include <gtest/gtest.h>

#include <random>

namespace qmesh {
namespace {

using Bytes = std::vector<std::uint8_t>;

Result<Bytes> unpack(const Bytes& bytes, std::size_t maxSize = 1 << 20) {
  return gunzip(bytes.data(), bytes.size(), maxSize);
}

/// "qmesh" in one stored block, by hand: header, block of 5, CRC-32 c2bbdb28, size 5.
Bytes storedMember() {
  return {0x1f, 0x8b, 8,   0,   0,   0,   0,    0,    0,    255,  1, 5, 0, 0xfa,
          0xff, 'q',  'm', 'e', 's', 'h', 0x28, 0xdb, 0xbb, 0xc2, 5, 0, 0, 0};
}

Bytes someText(std::mt19937& random, std::size_t size) {
  Bytes text;
  for (std::size_t i = 0; i < size; ++i)
    text.push_back(std::uint8_t('a' + random() % (1 + i % 7)));
  return text;
}

TEST(Gzip, ReadsAMemberWrittenByHand) {
  const auto text = unpack(storedMember());
  ASSERT_TRUE(text.ok()) << text.status().message();
  EXPECT_EQ(std::string(text->begin(), text->end()), "qmesh");
}

TEST(Gzip, UnpackingGivesTheBytesBack) {
  std::mt19937 random(61);
  GzipCompressor gzip;
  for (const std::size_t size : {0, 1, 2, 100, 5000, 300000, 17}) {
    const Bytes text = someText(random, size);
    const auto back = unpack(gzip.compress(text));
    ASSERT_TRUE(back.ok()) << back.status().message();
    EXPECT_EQ(*back, text);
  }
}

TEST(Gzip, BytesDependOnTheInputAlone) {
  std::mt19937 random(62);
  const Bytes text = someText(random, 4000);
  GzipCompressor used, fresh;
  used.compress(someText(random, 90000));
  const Bytes packed = used.compress(text);
  EXPECT_EQ(packed, fresh.compress(text));
  EXPECT_EQ(Bytes(packed.begin() + 4, packed.begin() + 8), Bytes(4, 0)) << "time stamp";
}

TEST(Gzip, KnowsItsOwnBeginning) {
  const Bytes member = storedMember();
  EXPECT_TRUE(isGzip(member.data(), member.size()));
  EXPECT_FALSE(isGzip(member.data(), 2));
  EXPECT_FALSE(isGzip(nullptr, 0));
  const Bytes other{0x1f, 0x8c, 8, 0};
  EXPECT_FALSE(isGzip(other.data(), other.size()));
}

TEST(Gzip, RefusesEveryShorterMember) {
  std::mt19937 random(63);
  const Bytes whole = GzipCompressor().compress(someText(random, 700));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto text = unpack(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size)));
    ASSERT_FALSE(text.ok()) << size;
    EXPECT_EQ(text.status().code(), Code::input);
  }
}

TEST(Gzip, NoChangeOfAByteGoesUnnoticed) {
  std::mt19937 random(64);
  const Bytes text = someText(random, 300);
  const Bytes whole = GzipCompressor().compress(text);
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      Bytes bytes = whole;
      bytes[at] = std::uint8_t(bytes[at] ^ (1 << bit));
      const auto back = unpack(bytes);
      if (back.ok()) {
        // Flags, time, level and system say nothing about the text, nor do the bits left over in
        // the last byte before checksum and size.
        EXPECT_TRUE((at >= 3 && at < 10) || at == whole.size() - 9) << at;
        EXPECT_EQ(*back, text);
      }
    }
}

TEST(Gzip, KeepsTheLimit) {
  const Bytes packed = GzipCompressor().compress(Bytes(1000, 7));
  EXPECT_TRUE(unpack(packed, 1000).ok());
  ASSERT_FALSE(unpack(packed, 999).ok());
  EXPECT_NE(unpack(packed, 999).status().message().find("limit"), std::string::npos);
}

TEST(Gzip, RefusesASizeThatCannotBe) {
  Bytes member = storedMember();
  member[member.size() - 1] = 0x70; // 1.9 GB out of 28 bytes: not even tried
  EXPECT_FALSE(unpack(member, std::size_t(1) << 31).ok());
  member = storedMember();
  member[member.size() - 4] = 4;
  EXPECT_FALSE(unpack(member).ok());
}

TEST(Gzip, RefusesWhatFollowsTheMember) {
  Bytes bytes = storedMember();
  bytes.push_back(0);
  EXPECT_FALSE(unpack(bytes).ok());
  bytes = storedMember();
  const Bytes second = storedMember();
  bytes.insert(bytes.end(), second.begin(), second.end());
  EXPECT_FALSE(unpack(bytes).ok());
}

} // namespace
} // namespace qmesh
