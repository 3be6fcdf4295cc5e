// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "base/enum_table.h"
#include "codec/gzip.h"
#include "export/export_choices.h"

namespace qmesh {

/// The pages written beside a tileset.
enum class Preview { none, cesium, all };

template <> struct EnumTable<Preview> {
  static constexpr EnumRow<Preview> kRows[] = {
      {Preview::none, "none", "no page"},
      {Preview::cesium, "cesium", "a CesiumJS page"},
      {Preview::all, "all", "all pages"},
  };
};

/// Where the tileset goes and what it holds beside triangles.
struct OutputOptions {
  std::string path; ///< folder, or archive below /vsizip/
  bool xyz = false; ///< rows of file names count from the north
  Compression compression = Compression::gzip;
  bool overwrite = false;
  bool normals = true;
  int metadata = 0;  ///< a tile of every so many zooms has the metadata extension; 0: none
  std::string title; ///< empty: the input's base name
  std::string copyright;
  Preview preview = Preview::none;
  std::string cesium;      ///< a CesiumJS build; empty: Cesium's download site
  std::string report;      ///< JSON file; empty: none
  std::string debugMeshes; ///< folder; empty: none
  MeshFormat debugFormat = MeshFormat::ply;
};

} // namespace qmesh
