// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "geo/octahedral.h"

#include <algorithm>
#include <cmath>

namespace qmesh {
namespace {

constexpr double kRange = 255;

double signNotZero(double value) {
  return value < 0 ? -1.0 : 1.0;
}

/// -1..1 to the nearest of 0..255.
std::uint8_t toByte(double value) {
  return std::uint8_t(std::lround((std::clamp(value, -1.0, 1.0) * 0.5 + 0.5) * kRange));
}

double fromByte(std::uint8_t byte) {
  return double(byte) / kRange * 2 - 1;
}

/// The lower half of the octahedron lies in the corners of the square, turned outwards.
void fold(double& x, double& y) {
  const double unfoldedX = x;
  x = (1 - std::abs(y)) * signNotZero(x);
  y = (1 - std::abs(unfoldedX)) * signNotZero(y);
}

bool onRim(std::uint8_t byte) {
  return byte == 0 || byte == 255;
}
std::uint8_t upperHalf(std::uint8_t byte) {
  return std::max(byte, std::uint8_t(255 - byte));
}

} // namespace

std::array<std::uint8_t, 2> octEncode(const Vec3& unit) {
  const double sum = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
  double x = unit.x / sum;
  double y = unit.y / sum;
  if (unit.z < 0)
    fold(x, y);
  const std::uint8_t a = toByte(x);
  const std::uint8_t b = toByte(y);
  // Two points of the square's rim that mirror each other are one direction: one of them is taken,
  // so that a last-bit difference of the input cannot show as different bytes.
  return {onRim(b) ? upperHalf(a) : a, onRim(a) ? upperHalf(b) : b};
}

Vec3 octDecode(std::array<std::uint8_t, 2> encoded) {
  double x = fromByte(encoded[0]);
  double y = fromByte(encoded[1]);
  const double z = 1 - (std::abs(x) + std::abs(y));
  if (z < 0)
    fold(x, y);
  return normalized({x, y, z});
}

} // namespace qmesh
