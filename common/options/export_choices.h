// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/enum_table.h"

namespace qmesh {

/// The coordinates a mesh is written in for other programs.
enum class MeshFrame { local, ecef, lonlat };

/// What the colour of a drawn triangle tells.
enum class MeshShade { height, slope, none };

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

} // namespace qmesh
