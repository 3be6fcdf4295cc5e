// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "sink/tileset_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <functional>

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include "base/text.h"
#include "sink/tileset_swap.h"
#include "vsi/folder_lock.h"
#include "vsi/quiet_errors.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

/// A layer.json says its format within so many bytes; `available`, which may be long, comes later.
constexpr std::size_t kHeadBytes = 16384;

/// The preview page of gdal2qmesh, told from a page of somebody else's by its second line.
constexpr std::array<const char*, 4> kPreviewNames = {"index.html", "preview.js", "look.js",
                                                      "preview.css"};
constexpr const char* kPreviewMark = "the qmesh authors";
constexpr std::size_t kPreviewHeadBytes = 256;

constexpr const char* kNotes = ".aux.xml";

std::string readHead(const std::string& path, std::size_t bytes) {
  QuietErrors errors;
  VSILFILE* file = VSIFOpenL(path.c_str(), "rb");
  if (!file)
    return {};
  std::string head(bytes, '\0');
  head.resize(VSIFReadL(head.data(), 1, bytes, file));
  VSIFCloseL(file);
  return head;
}

/// Relative paths of a set's files but layer.json, and of the folders that hold tiles, each after
/// those in it.
struct SetFiles {
  std::vector<std::string> files;
  std::vector<std::string> folders;
};

SetFiles listSet(const std::string& folder) {
  SetFiles set;
  for (const std::string& zoom : listFolder(folder)) {
    if (!isZoomName(zoom) || !isFolder(folder + "/" + zoom))
      continue;
    for (const std::string& column : listFolder(folder + "/" + zoom)) {
      const std::string path = zoom + "/" + column;
      bool any = false;
      for (const std::string& name : listFolder(folder + "/" + path))
        if (isTileName(name)) {
          set.files.push_back(path + "/" + name);
          any = true;
        }
      if (any)
        set.folders.push_back(path);
    }
    set.folders.push_back(zoom);
  }
  for (const char* name : kPreviewNames)
    if (readHead(folder + "/" + name, kPreviewHeadBytes).find(kPreviewMark) != std::string::npos)
      set.files.push_back(name);
  const std::string notes = std::string(kLayerJsonName) + kNotes;
  if (pathExists(folder + "/" + notes))
    set.files.push_back(notes);
  return set;
}

Status noSet(const std::string& folder) {
  return {Code::output,
          "'" + folder + "' is not a quantized-mesh set: it has no layer.json of one"};
}

Status unlinkFile(const std::string& path) {
  errno = 0;
  return VSIUnlink(path.c_str()) == 0 ? Status()
                                      : outputError("'" + path + "' cannot be removed", errno);
}

void removeEmptyFolders(const std::string& folder, const std::vector<std::string>& folders) {
  QuietErrors errors;
  for (const std::string& path : folders)
    if (listFolder(folder + "/" + path).empty())
      VSIRmdir((folder + "/" + path).c_str());
  if (listFolder(folder).empty())
    VSIRmdir(folder.c_str());
}

/// What a stopped run left. Parts of an older set that it could not put back stay.
Status removeLeftover(const std::string& folder) {
  const std::string hidden = folder + "/" + kHiddenFolderName;
  if (!pathExists(hidden))
    return {};
  FolderLock lock;
  QMESH_RETURN_IF_ERROR(lock.acquire(hidden + "/" + kLockFileName));
  if (pathExists(hidden + "/journal"))
    return {};
  removeTree(hidden);
  return {};
}

/// GDAL can neither remove nor move what is in an archive, nor add to a finished one.
Status checkNoArchive(const std::string& folder) {
  if (folder.rfind("/vsizip/", 0) != 0 && folder.rfind("/vsitar/", 0) != 0)
    return {};
  return {Code::output,
          "'" + folder + "' lies in an archive, which stays as it is; use the archive's own file"};
}

Status checkTarget(const std::string& from, const std::string& to) {
  if (!holdsTileset(from))
    return noSet(from);
  QMESH_RETURN_IF_ERROR(checkNoArchive(to));
  if (pathExists(to) && (!isFolder(to) || !listFolder(to).empty()))
    return {Code::output, "'" + to + "' exists already; name another folder"};
  return makeFolders(to);
}

Status copyFile(const std::string& from, const std::string& to) {
  QuietErrors errors;
  VSILFILE* file = VSIFOpenL(from.c_str(), "rb");
  if (!file)
    return {Code::output, "'" + from + "' cannot be read"};
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 65536> part{};
  for (std::size_t got = 0; (got = VSIFReadL(part.data(), 1, part.size(), file)) > 0;)
    bytes.insert(bytes.end(), part.begin(), part.begin() + std::ptrdiff_t(got));
  VSIFCloseL(file);
  return writeWholeFile(to, bytes.data(), bytes.size());
}

using FileAction = std::function<Status(const std::string& from, const std::string& to)>;

/// `action` for each file of the set, layer.json last, and for the note beside the folder.
Status forEachFile(const SetFiles& set, const std::string& from, const std::string& to,
                   const FileAction& action) {
  for (const std::string& name : set.files) {
    const std::string target = to + "/" + name;
    QMESH_RETURN_IF_ERROR(makeFolders(target.substr(0, target.rfind('/'))));
    QMESH_RETURN_IF_ERROR(action(from + "/" + name, target));
  }
  if (pathExists(from + kNotes))
    QMESH_RETURN_IF_ERROR(action(from + kNotes, to + kNotes));
  return action(from + "/" + kLayerJsonName, to + "/" + kLayerJsonName);
}

} // namespace

std::string tileFileName(TileId tile, bool xyz) {
  const std::uint32_t row = xyz ? (std::uint32_t(1) << tile.z) - 1 - tile.y : tile.y;
  return std::to_string(tile.z) + "/" + std::to_string(tile.x) + "/" + std::to_string(row) +
         ".terrain";
}

bool isTilesetFile(const std::string& name) {
  const auto parts = split(name, '/');
  if (parts.size() == 3)
    return isZoomName(std::string(parts[0])) && parseInteger(parts[1]) &&
           isTileName(std::string(parts[2]));
  return name == kLayerJsonName || name == std::string(kLayerJsonName) + kNotes ||
         std::find(kPreviewNames.begin(), kPreviewNames.end(), name) != kPreviewNames.end();
}

bool saysQuantizedMesh(const std::string& head) {
  const std::size_t begin = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return begin != std::string::npos && head[begin] == '{' &&
         head.find("\"quantized-mesh-1.") != std::string::npos;
}

bool holdsTileset(const std::string& folder) {
  return saysQuantizedMesh(readHead(folder + "/" + kLayerJsonName, kHeadBytes));
}

bool holdsFiles(const std::string& folder) {
  for (const std::string& name : listFolder(folder))
    if (name != kHiddenFolderName)
      return true;
  return false;
}

void removeNotes(const std::string& folder) {
  QuietErrors errors;
  VSIUnlink((folder + kNotes).c_str());
  VSIUnlink((folder + "/" + kLayerJsonName + kNotes).c_str());
}

Status deleteTileset(const std::string& folder) {
  if (!holdsTileset(folder))
    return noSet(folder);
  QMESH_RETURN_IF_ERROR(checkNoArchive(folder));
  QuietErrors errors;
  QMESH_RETURN_IF_ERROR(removeLeftover(folder));
  const SetFiles set = listSet(folder);
  QMESH_RETURN_IF_ERROR(unlinkFile(folder + "/" + kLayerJsonName));
  for (const std::string& name : set.files)
    QMESH_RETURN_IF_ERROR(unlinkFile(folder + "/" + name));
  removeNotes(folder);
  removeEmptyFolders(folder, set.folders);
  return {};
}

Status renameTileset(const std::string& from, const std::string& to) {
  QMESH_RETURN_IF_ERROR(checkNoArchive(from));
  QMESH_RETURN_IF_ERROR(checkTarget(from, to));
  // Without its layer.json nobody takes a half-moved set for a whole one.
  const std::string layer = from + "/" + kLayerJsonName;
  const std::string aside = to + "/" + kLayerJsonName + ".moving";
  if (!renamePath(layer, aside).ok()) { // another file system
    QMESH_RETURN_IF_ERROR(copyTileset(from, to));
    return deleteTileset(from);
  }
  const SetFiles set = listSet(from);
  const auto move = [&](const std::string& a, const std::string& b) {
    return renamePath(a == layer ? aside : a, b);
  };
  Status status = forEachFile(set, from, to, move);
  if (status.ok()) {
    removeEmptyFolders(from, set.folders);
    return {};
  }
  for (const std::string& name : set.files)
    if (pathExists(to + "/" + name))
      QMESH_RETURN_IF_ERROR(renamePath(to + "/" + name, from + "/" + name));
  QMESH_RETURN_IF_ERROR(renamePath(aside, layer));
  removeEmptyFolders(to, set.folders);
  return status;
}

Status copyTileset(const std::string& from, const std::string& to) {
  QMESH_RETURN_IF_ERROR(checkTarget(from, to));
  const SetFiles set = listSet(from);
  Status status = forEachFile(set, from, to, copyFile);
  if (!status.ok()) {
    QuietErrors errors;
    for (const std::string& name : set.files)
      VSIUnlink((to + "/" + name).c_str());
    removeNotes(to);
    removeEmptyFolders(to, set.folders);
  }
  return status;
}

} // namespace qmesh
