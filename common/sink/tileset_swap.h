// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "base/status.h"

namespace qmesh {

/// Puts a finished set in place of the one that is there, so that whatever happens, also a kill
/// between two steps, one of the two can be had whole.
///
/// In the hidden folder: new/ is the set to be put in place, with its layer.json; old/ takes what
/// was there; `journal` lists what is moved in. Order of the moves: the old layer.json and zoom
/// folders out, the new zoom folders and files in, files that are not ours back into their zoom
/// folders, the new layer.json in. That last step decides: with it the new set counts, without it
/// undo() restores the old one.
class TilesetSwap {
 public:
  TilesetSwap(std::string output, std::string hidden);

  std::string newFolder() const { return hidden_ + "/new"; }

  /// All that is in new/ goes to the output. `files`: the files beside the zoom folders, relative,
  /// without layer.json. After an error the output is as it was, unless the message says otherwise.
  Status run(const std::vector<std::string>& files);

  /// Takes a swap back that did not get to its last step; nothing to do when there was none. May be
  /// called again after a kill or an error: each step leaves a state that it can start from. After
  /// an error old/ still holds what could not be put back.
  Status undo();

 private:
  Status moveOut(const std::string& name);
  Status moveIn(const std::string& name);
  Status moveForeign(const std::string& from, const std::string& to, int depth);
  Status moveAll(const std::vector<std::string>& items);
  Status takeBack(const std::string& item, bool listed);

  std::string output_, hidden_;
};

/// True for the name of a zoom folder, "0" to "24".
bool isZoomName(const std::string& name);

/// True for the name of a tile's file, "<int>.terrain".
bool isTileName(const std::string& name);

/// True where a zoom folder holds a tile of ours, <int>/<int>.terrain.
bool holdsTiles(const std::string& zoomFolder);

} // namespace qmesh
