// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "options/build_options.h"

namespace qmesh {

/// A text file of the preview page and its name in the output folder.
struct PreviewFile {
  std::string name;
  std::string text;
};

/// The folder in the output that holds the copy of CesiumJS made for --cesium.
extern const char kCesiumFolder[];

/// The preview page of a set: index.html and what it loads, to lie beside layer.json. Empty for
/// Preview::none. The page takes CesiumJS from the folder kCesiumFolder where --cesium is given,
/// else from the project's own download site, one fixed version. Its heading is --title, else the
/// input's base name.
std::vector<PreviewFile> previewFiles(const BuildOptions& options);

/// What --cesium names, to check before the work starts: the folder with Cesium.js itself, where
/// `folder` is that or an unpacked release with Build/Cesium in it. Code::usage where there is
/// none.
Result<std::string> findCesium(const std::string& folder);

/// Copies the CesiumJS that findCesium(folder) finds into `output`, a folder on a local disk, as
/// kCesiumFolder; an earlier copy is replaced only by a complete new one. Code::output where that
/// fails.
Status copyCesium(const std::string& folder, const std::string& output);

} // namespace qmesh
