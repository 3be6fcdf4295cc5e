// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "grid/height_tile.h"
#include "mesh/level_params.h"

namespace qmesh::test {

/// Kinds of synthetic terrain; all pure functions of the seed.
enum class Terrain { fractal, ridged, spikes, plane, steps, checkerboard, flat, extreme, cliff };

inline constexpr Terrain kTerrains[] = {Terrain::fractal, Terrain::ridged,  Terrain::spikes,
                                        Terrain::plane,   Terrain::steps,   Terrain::checkerboard,
                                        Terrain::flat,    Terrain::extreme, Terrain::cliff};

inline const char* name(Terrain terrain) {
  static const char* const names[] = {"fractal",      "ridged", "spikes",  "plane", "steps",
                                      "checkerboard", "flat",   "extreme", "cliff"};
  return names[int(terrain)];
}

/// A patch of tiles with one halo around, cut from one random field.
class TerrainPatch {
 public:
  /// The tiles first.x .. first.x + across - 1 (wrapped) by first.y .. first.y + up - 1.
  TerrainPatch(const NodeLattice& lattice, TileId first, int across, int up, Terrain terrain,
               unsigned seed)
      : lattice_(lattice), first_(first), columns_(across * lattice.cells() + 1 + 2 * kTileHalo),
        rows_(up * lattice.cells() + 1 + 2 * kTileHalo), seed_(seed) {
    std::mt19937 random(seed);
    heights_.resize(std::size_t(columns_) * std::size_t(rows_));
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i)
        heights_[std::size_t(j * columns_ + i)] = float(height(terrain, i, j, random));
    }
    levelPoles();
  }

  HeightTile tile(int dx = 0, int dy = 0) const {
    TileId id = first_;
    id.x = (first_.x + std::uint32_t(dx)) % lattice_.scheme().tilesX(first_.z);
    id.y += std::uint32_t(dy);
    const int n = lattice_.cells();
    return {id, lattice_,
            heights_.data() + std::ptrdiff_t(dy * n + kTileHalo) * columns_ + dx * n + kTileHalo,
            columns_};
  }

  /// Of node (i, j) of the first tile.
  float& at(int i, int j) {
    return heights_[std::size_t((j + kTileHalo) * columns_ + i + kTileHalo)];
  }

 private:
  double noise(int i, int j) const {
    std::uint32_t h = std::uint32_t(i) * 0x9E3779B1u ^ std::uint32_t(j) * 0x85EBCA77u ^ seed_;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return double((h ^ (h >> 15)) & 0xffffffu) / 0x1000000;
  }

  double smooth(double x, double y) const {
    const double fx = std::floor(x), fy = std::floor(y);
    const int i = int(fx), j = int(fy);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double a = ease(x - fx), b = ease(y - fy);
    return (noise(i, j) * (1 - a) + noise(i + 1, j) * a) * (1 - b) +
           (noise(i, j + 1) * (1 - a) + noise(i + 1, j + 1) * a) * b;
  }

  double octaves(int i, int j, bool ridged) const {
    double sum = 0, amplitude = 1;
    for (double scale = lattice_.cells() / 2.0; scale > 0.7; scale /= 2, amplitude *= 0.5) {
      const double value = smooth(i / scale, j / scale);
      sum += amplitude * (ridged ? 1 - std::abs(2 * value - 1) : value);
    }
    return sum;
  }

  double height(Terrain terrain, int i, int j, std::mt19937& random) const {
    switch (terrain) {
    case Terrain::fractal:
      return 800 * octaves(i, j, false) - 300;
    case Terrain::ridged:
      return 1500 * octaves(i, j, true);
    case Terrain::spikes:
      return random() % 97 == 0 ? double(random() % 4000) : 12.25;
    case Terrain::plane:
      return 3.5 * i - 7.25 * j + 100;
    case Terrain::steps:
      return 250 * std::floor((i + 2 * j) / 7.0);
    case Terrain::checkerboard:
      return (i + j) % 2 ? 40 : -40;
    case Terrain::flat:
      return -3.7;
    case Terrain::extreme:
      return 18000 * noise(i, j) - 9000;
    case Terrain::cliff:
      return i * 2 + j > columns_ ? 29000 + octaves(i, j, false) : -1000;
    }
    return 0;
  }

  /// A pole is one point: one height.
  void levelPoles() {
    for (int j = 0; j < rows_; ++j) {
      if (!lattice_.isPole(std::int64_t(first_.y) * lattice_.cells() + j - kTileHalo))
        continue;
      for (int i = 0; i < columns_; ++i)
        heights_[std::size_t(j * columns_ + i)] = heights_[std::size_t(j * columns_)];
    }
  }

  NodeLattice lattice_;
  TileId first_;
  int columns_;
  int rows_;
  std::uint32_t seed_;
  std::vector<float> heights_;
};

/// One tile's place in a pyramid.
struct Place {
  Profile profile;
  int zoom;
  std::uint32_t x;
  std::uint32_t y;
  int cells;

  NodeLattice lattice() const { return {Scheme(profile), zoom, cells}; }
  TileId id() const { return {zoom, x, y}; }
  LevelParams level(double maxError) const {
    return levelParams(Scheme(profile), zoom, maxError, cells);
  }
};

inline std::ostream& operator<<(std::ostream& out, const Place& place) {
  return out << (place.profile == Profile::geodetic ? "geodetic " : "mercator ") << place.zoom
             << "/" << place.x << "/" << place.y << " N " << place.cells;
}

/// Both profiles, the first and the deepest zooms, both poles and the lattice's ends.
inline std::vector<Place> places() {
  using P = Profile;
  return {{P::geodetic, 0, 0, 0, 8},          {P::geodetic, 0, 1, 0, 64},
          {P::geodetic, 1, 3, 1, 16},         {P::geodetic, 4, 3, 15, 64},
          {P::geodetic, 4, 31, 0, 16},        {P::geodetic, 9, 513, 300, 64},
          {P::geodetic, 12, 1411, 2828, 256}, {P::geodetic, 20, 99999, 700001, 16},
          {P::mercator, 0, 0, 0, 64},         {P::mercator, 3, 7, 7, 16},
          {P::mercator, 3, 2, 0, 32},         {P::mercator, 11, 352, 1300, 128},
          {P::mercator, 20, 12345, 543210, 8}};
}

} // namespace qmesh::test
