// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "sink/tileset_swap.h"

#include <algorithm>

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include "base/text.h"
#include "sink/tileset_files.h"
#include "tiling/scheme.h"
#include "vsi/quiet_errors.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

bool isDigits(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string folderOf(const std::string& path) {
  return path.substr(0, path.rfind('/'));
}

/// Removes a folder and those above it below `top`, as far as they are empty.
void removeEmptyFolders(std::string folder, const std::string& top) {
  QuietErrors errors;
  while (folder.size() > top.size() && listFolder(folder).empty() && VSIRmdir(folder.c_str()) == 0)
    folder = folderOf(folder);
}

std::vector<std::string> readLines(const std::string& path) {
  std::vector<std::string> out;
  GByte* bytes = nullptr;
  vsi_l_offset size = 0;
  QuietErrors errors;
  if (!VSIIngestFile(nullptr, path.c_str(), &bytes, &size, -1))
    return out;
  for (std::string_view line :
       split({reinterpret_cast<const char*>(bytes), std::size_t(size)}, '\n'))
    if (!line.empty())
      out.emplace_back(line);
  VSIFree(bytes);
  return out;
}

} // namespace

bool isZoomName(const std::string& name) {
  return isDigits(name) && name.size() <= 2 && (name.size() == 1 || name[0] != '0') &&
         std::stoi(name) <= kMaxZoom;
}

bool isTileName(const std::string& name) {
  const std::size_t dot = name.find('.');
  return dot != std::string::npos && isDigits(name.substr(0, dot)) &&
         name.substr(dot) == ".terrain";
}

bool holdsTiles(const std::string& zoomFolder) {
  for (const std::string& column : listFolder(zoomFolder))
    if (isDigits(column))
      for (const std::string& name : listFolder(zoomFolder + "/" + column))
        if (isTileName(name))
          return true;
  return false;
}

TilesetSwap::TilesetSwap(std::string output, std::string hidden)
    : output_(std::move(output)), hidden_(std::move(hidden)) {}

Status TilesetSwap::moveOut(const std::string& name) {
  const std::string from = output_ + "/" + name;
  if (!pathExists(from))
    return {};
  if (isFolder(from) != isZoomName(name))
    return {Code::output, "'" + from + "' is in the way; move it elsewhere"};
  const std::string to = hidden_ + "/old/" + name;
  QMESH_RETURN_IF_ERROR(makeFolders(folderOf(to)));
  return renamePath(from, to);
}

Status TilesetSwap::moveIn(const std::string& name) {
  const std::string to = output_ + "/" + name;
  QMESH_RETURN_IF_ERROR(makeFolders(folderOf(to)));
  return renamePath(newFolder() + "/" + name, to);
}

/// What is not ours moves from one zoom folder (depth 0) or column folder (depth 1) to another.
Status TilesetSwap::moveForeign(const std::string& from, const std::string& to, int depth) {
  for (const std::string& name : listFolder(from)) {
    const std::string path = from + "/" + name;
    if (depth == 0 && isDigits(name) && isFolder(path)) {
      QMESH_RETURN_IF_ERROR(moveForeign(path, to + "/" + name, 1));
    } else if (depth == 0 || !isTileName(name)) {
      QMESH_RETURN_IF_ERROR(makeFolders(to));
      QMESH_RETURN_IF_ERROR(renamePath(path, to + "/" + name));
    }
  }
  return {};
}

Status TilesetSwap::moveAll(const std::vector<std::string>& items) {
  QMESH_RETURN_IF_ERROR(moveOut(kLayerJsonName));
  for (const std::string& name : listFolder(output_)) {
    const bool replaced = std::find(items.begin(), items.end(), name) != items.end();
    if (isZoomName(name) && (replaced || holdsTiles(output_ + "/" + name)))
      QMESH_RETURN_IF_ERROR(moveOut(name));
  }
  for (const std::string& item : items) {
    QMESH_RETURN_IF_ERROR(moveOut(item)); // files; the zoom folders are out already
    QMESH_RETURN_IF_ERROR(moveIn(item));
  }
  for (const std::string& name : listFolder(hidden_ + "/old"))
    if (isZoomName(name))
      QMESH_RETURN_IF_ERROR(moveForeign(hidden_ + "/old/" + name, output_ + "/" + name, 0));
  return moveIn(kLayerJsonName);
}

Status TilesetSwap::run(const std::vector<std::string>& files) {
  std::vector<std::string> items = files;
  for (const std::string& name : listFolder(newFolder()))
    if (isZoomName(name))
      items.push_back(name);
  std::string journal;
  for (const std::string& item : items)
    journal += item + "\n";
  QMESH_RETURN_IF_ERROR(writeWholeFile(hidden_ + "/journal", journal.data(), journal.size()));
  Status status = moveAll(items);
  if (status.ok())
    return status;
  const Status undone = undo();
  if (undone.ok())
    return status;
  return {Code::output, status.message() +
                            "; and what was there before could not be put back: it is in '" +
                            hidden_ + "/old' (" + undone.message() + ")"};
}

/// Takes one zoom folder or file out again and puts the old one back. `listed`: named in the
/// journal.
Status TilesetSwap::takeBack(const std::string& item, bool listed) {
  const std::string there = output_ + "/" + item;
  const std::string made = newFolder() + "/" + item;
  const std::string old = hidden_ + "/old/" + item;
  if (!pathExists(made) && pathExists(there) && (listed || pathExists(old))) {
    QMESH_RETURN_IF_ERROR(makeFolders(folderOf(made)));
    QMESH_RETURN_IF_ERROR(renamePath(there, made));
  }
  if (!pathExists(old)) {
    if (listed)
      removeEmptyFolders(folderOf(there), output_);
    return {};
  }
  if (isZoomName(item))
    QMESH_RETURN_IF_ERROR(moveForeign(made, old, 0));
  QMESH_RETURN_IF_ERROR(makeFolders(folderOf(there)));
  return renamePath(old, there);
}

Status TilesetSwap::undo() {
  const std::string journal = hidden_ + "/journal";
  if (!pathExists(newFolder() + "/" + kLayerJsonName) || !pathExists(journal))
    return {};
  for (const std::string& item : readLines(journal))
    QMESH_RETURN_IF_ERROR(takeBack(item, true));
  for (const std::string& name : listFolder(hidden_ + "/old"))
    if (isZoomName(name))
      QMESH_RETURN_IF_ERROR(takeBack(name, false));
  const std::string oldLayer = hidden_ + "/old/" + kLayerJsonName;
  if (pathExists(oldLayer))
    QMESH_RETURN_IF_ERROR(renamePath(oldLayer, output_ + "/" + kLayerJsonName));
  VSIUnlink(journal.c_str());
  return {};
}

} // namespace qmesh
