// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "geo/octahedral.h"

#include <gtest/gtest.h>

#include "random_vectors.h"

namespace qmesh {
namespace {

using test::angleBetween;
using test::RandomVectors;

/// Where a byte pair points, worked out another way than the code does: the square is pulled over
/// the octahedron |x| + |y| + |z| = 1, whose lower faces are mirrored at the square's inner
/// diamond.
Vec3 referenceDecode(int a, int b) {
  const double s = 2 * a / 255.0 - 1, t = 2 * b / 255.0 - 1;
  const double height = 1 - std::abs(s) - std::abs(t);
  if (height >= 0)
    return normalized({s, t, height});
  const double x = std::copysign(1 - std::abs(t), s), y = std::copysign(1 - std::abs(s), t);
  return normalized({x, y, height});
}

TEST(Octahedral, DecodesEveryBytePair) {
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; ++b) {
      const Vec3 decoded = octDecode({std::uint8_t(a), std::uint8_t(b)});
      EXPECT_LT(angleBetween(decoded, referenceDecode(a, b)), 1e-14) << a << " " << b;
      EXPECT_NEAR(length(decoded), 1, 1e-15);
    }
}

TEST(Octahedral, AxesAsClientsEncodeThem) {
  using Bytes = std::array<std::uint8_t, 2>;
  EXPECT_EQ(octEncode({0, 0, 1}), (Bytes{128, 128}));
  EXPECT_EQ(octEncode({1, 0, 0}), (Bytes{255, 128}));
  EXPECT_EQ(octEncode({0, 1, 0}), (Bytes{128, 255}));
  EXPECT_EQ(octEncode({-1, 0, 0}), (Bytes{0, 128}));
  EXPECT_EQ(octEncode({0, 0, -1}), (Bytes{255, 255}));
}

TEST(Octahedral, ErrorStaysBelowADegree) {
  RandomVectors random(3);
  double worst = 0;
  for (int k = 0; k < 200000; ++k) {
    const Vec3 v = random.direction();
    worst = std::max(worst, angleBetween(octDecode(octEncode(v)), v));
  }
  EXPECT_LT(worst * 180 / 3.14159265358979, 1.0);
}

TEST(Octahedral, EncodingADecodedDirectionChangesNothing) {
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; ++b) {
      const std::array<std::uint8_t, 2> bytes{std::uint8_t(a), std::uint8_t(b)};
      const auto again = octEncode(octDecode(bytes));
      EXPECT_LT(angleBetween(octDecode(again), octDecode(bytes)), 1e-14) << a << " " << b;
      EXPECT_EQ(octEncode(octDecode(again)), again);
      const bool rim = a == 0 || a == 255 || b == 0 || b == 255;
      if (!rim) {
        EXPECT_EQ(again, bytes);
      }
    }
}

TEST(Octahedral, SignOfZeroDoesNotShow) {
  RandomVectors random(4);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 v = random.direction();
    EXPECT_EQ(octEncode(normalized({0.0, v.y, v.z})), octEncode(normalized({-0.0, v.y, v.z})));
    EXPECT_EQ(octEncode(normalized({v.x, 1e-18, v.z})), octEncode(normalized({v.x, -1e-18, v.z})));
  }
}

} // namespace
} // namespace qmesh
