// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <random>

#include "geo/vec3.h"

namespace qmesh::test {

/// Random numbers and directions of a fixed seed, so that a failure can be repeated.
class RandomVectors {
 public:
  explicit RandomVectors(unsigned seed) : engine_(seed) {}

  double real(double low, double high) {
    return low + (high - low) * (double(engine_()) / 4294967296.0);
  }

  /// Uniform on the unit sphere.
  Vec3 direction() {
    for (;;) {
      const Vec3 v{real(-1, 1), real(-1, 1), real(-1, 1)};
      const double size = length(v);
      if (size > 0.01 && size <= 1)
        return v * (1 / size);
    }
  }

 private:
  std::mt19937 engine_;
};

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Radians, exact also for nearly parallel vectors.
inline double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

} // namespace qmesh::test
