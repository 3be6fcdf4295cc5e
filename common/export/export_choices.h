// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/enum_table.h"

namespace qmesh {

/// The coordinates a mesh is written in for other programs.
enum class MeshFrame { local, ecef, lonlat };

/// What the colour of a drawn triangle tells.
enum class MeshShade { height, slope, none };

/// The file format of a mesh for other programs.
enum class MeshFormat { ply, obj, off };

template <> struct EnumTable<MeshFrame> {
  static constexpr EnumRow<MeshFrame> kRows[] = {
      {MeshFrame::local, "local", "metres east, north and up from the middle of the tile"},
      {MeshFrame::ecef, "ecef", "earth-centred, earth-fixed metres"},
      {MeshFrame::lonlat, "lonlat", "degrees of longitude and latitude, metres of height"},
  };
};

template <> struct EnumTable<MeshShade> {
  static constexpr EnumRow<MeshShade> kRows[] = {
      {MeshShade::height, "height",
       "green low, brown higher, white high; hills lit from the north-west"},
      {MeshShade::slope, "slope", "white flat, dark steep"},
      {MeshShade::none, "none", "white; lines only"},
  };
};

template <> struct EnumTable<MeshFormat> {
  static constexpr EnumRow<MeshFormat> kRows[] = {
      {MeshFormat::ply, "ply", "Stanford PLY"},
      {MeshFormat::obj, "obj", "Wavefront OBJ"},
      {MeshFormat::off, "off", "Geomview OFF"},
  };
};

} // namespace qmesh
