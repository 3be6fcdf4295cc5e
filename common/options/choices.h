// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/enum_table.h"

namespace qmesh {

enum class ProfileChoice { geodetic, mercator };
enum class Resampling { nearest, bilinear, cubic, cubicspline, lanczos, average };
enum class OverviewResampling { nearest, average, cubic };
enum class Compression { gzip, none };
enum class Preview { none, cesium, all };
enum class VoidFill { value, interpolate };
enum class Switch { off, on };
enum class BorderMode { shared, inherit };
enum class Schedule { fourColour, rowwise, columnwise, chessboard, fourConnected };
enum class ErrorType { height, distance3d };
enum class CollapseCost { lindstromTurk, garlandHeckbert };
enum class CollapseSpace { scaled, metric };

template <> struct EnumTable<ProfileChoice> {
  static constexpr EnumRow<ProfileChoice> kRows[] = {
      {ProfileChoice::geodetic, "geodetic", "EPSG:4326, two root tiles"},
      {ProfileChoice::mercator, "mercator", "EPSG:3857, one root tile"},
  };
};

template <> struct EnumTable<Resampling> {
  static constexpr EnumRow<Resampling> kRows[] = {
      {Resampling::nearest, "nearest", "the height of the nearest cell"},
      {Resampling::bilinear, "bilinear", "linear between 2 x 2 cells"},
      {Resampling::cubic, "cubic", "cubic convolution of 4 x 4 cells"},
      {Resampling::cubicspline, "cubicspline", "cubic B-spline of 4 x 4 cells, smooths"},
      {Resampling::lanczos, "lanczos", "windowed sinc of 6 x 6 cells"},
      {Resampling::average, "average", "mean of the cells around a node"},
      {Resampling::nearest, "near"},
  };
};

template <> struct EnumTable<OverviewResampling> {
  static constexpr EnumRow<OverviewResampling> kRows[] = {
      {OverviewResampling::nearest, "nearest", "every second node"},
      {OverviewResampling::average, "average", "weights 1 2 1 over valid nodes"},
      {OverviewResampling::cubic, "cubic", "sharper than average"},
      {OverviewResampling::nearest, "near"},
  };
};

template <> struct EnumTable<Compression> {
  static constexpr EnumRow<Compression> kRows[] = {
      {Compression::gzip, "gzip", "the server must send Content-Encoding: gzip"},
      {Compression::none, "none", "larger files that any server can send"},
  };
};

template <> struct EnumTable<Preview> {
  static constexpr EnumRow<Preview> kRows[] = {
      {Preview::none, "none", "no page"},
      {Preview::cesium, "cesium", "a CesiumJS page"},
      {Preview::all, "all", "every page there is"},
  };
};

template <> struct EnumTable<VoidFill> {
  static constexpr EnumRow<VoidFill> kRows[] = {
      {VoidFill::value, "value", "one height"},
      {VoidFill::interpolate, "interpolate", "from the valid heights around"},
  };
};

template <> struct EnumTable<Switch> {
  static constexpr EnumRow<Switch> kRows[] = {
      {Switch::on, "on", "do it"}, {Switch::off, "off", "leave it out"},
      {Switch::on, "yes"},         {Switch::off, "no"},
      {Switch::on, "true"},        {Switch::off, "false"},
      {Switch::on, "1"},           {Switch::off, "0"},
  };
};

template <> struct EnumTable<BorderMode> {
  static constexpr EnumRow<BorderMode> kRows[] = {
      {BorderMode::shared, "shared", "an edge is a function of its own nodes; in any order"},
      {BorderMode::inherit, "inherit", "a tile takes the edges of neighbours already built"},
  };
};

template <> struct EnumTable<Schedule> {
  static constexpr EnumRow<Schedule> kRows[] = {
      {Schedule::fourColour, "four-colour", "tiles of one colour never touch"},
      {Schedule::rowwise, "rowwise", "row by row from the south"},
      {Schedule::columnwise, "columnwise", "column by column from the west"},
      {Schedule::chessboard, "chessboard", "the black squares, then the white ones"},
      {Schedule::fourConnected, "4connected", "tiles with the most edges already built first"},
      {Schedule::fourColour, "four-color"},
  };
};

template <> struct EnumTable<ErrorType> {
  static constexpr EnumRow<ErrorType> kRows[] = {
      {ErrorType::height, "height", "vertical"},
      {ErrorType::distance3d, "3d", "across the triangle's plane, smaller on slopes"},
  };
};

template <> struct EnumTable<CollapseCost> {
  static constexpr EnumRow<CollapseCost> kRows[] = {
      {CollapseCost::lindstromTurk, "lindstrom-turk", "keeps volume, boundary and shape"},
      {CollapseCost::garlandHeckbert, "garland-heckbert", "quadrics of the planes around"},
  };
};

template <> struct EnumTable<CollapseSpace> {
  static constexpr EnumRow<CollapseSpace> kRows[] = {
      {CollapseSpace::scaled, "scaled", "the tile as a unit cube"},
      {CollapseSpace::metric, "metric", "metres around the tile's centre"},
  };
};

} // namespace qmesh
