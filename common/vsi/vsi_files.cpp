// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "vsi/vsi_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <system_error>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

constexpr long kFolderMode = 0777;

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

/// Opens for writing; makes the folder when it is missing. The first file of each folder finds that
/// out, so nobody needs a list of folders; but GDAL's memory takes files without folders and does
/// not list them then.
VSILFILE* openForWriting(const std::string& path) {
  if (!isLocalPath(path) && !makeFolders(folderOf(path)).ok())
    return nullptr;
  VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
  if (file || errno != ENOENT || !makeFolders(folderOf(path)).ok())
    return file;
  return VSIFOpenL(path.c_str(), "wb");
}

} // namespace

bool isLocalPath(const std::string& path) {
  return path.rfind("/vsi", 0) != 0;
}

bool pathExists(const std::string& path) {
  VSIStatBufL info;
  return VSIStatExL(path.c_str(), &info, VSI_STAT_EXISTS_FLAG) == 0;
}

bool isFolder(const std::string& path) {
  VSIStatBufL info;
  return VSIStatExL(path.c_str(), &info, VSI_STAT_EXISTS_FLAG | VSI_STAT_NATURE_FLAG) == 0 &&
         VSI_ISDIR(info.st_mode);
}

std::vector<std::string> listFolder(const std::string& path) {
  const CPLStringList names(VSIReadDir(path.c_str()));
  std::vector<std::string> out;
  for (int k = 0; k < names.Count(); ++k) {
    std::string name = names[k];
    while (!name.empty() && name.back() == '/')
      name.pop_back();
    if (!name.empty() && name != "." && name != "..")
      out.push_back(std::move(name));
  }
  std::sort(out.begin(), out.end());
  return out;
}

Status outputError(const std::string& sentence, int error) {
  const std::string reason = error != 0 ? std::generic_category().message(error) : "reason unknown";
  return {Code::output, sentence + ": " + reason};
}

Status makeFolders(const std::string& path, std::vector<std::string>* made) {
  // One look only: between two another thread may make the folder.
  VSIStatBufL info;
  const bool exists = !path.empty() && VSIStatExL(path.c_str(), &info,
                                                  VSI_STAT_EXISTS_FLAG | VSI_STAT_NATURE_FLAG) == 0;
  if (path.empty() || (exists && VSI_ISDIR(info.st_mode)))
    return {};
  if (exists)
    return {Code::output, "'" + path + "' is a file, so there can be no folder in its place"};
  const std::size_t slash = path.rfind('/');
  if (slash != std::string::npos && slash > 0)
    QMESH_RETURN_IF_ERROR(makeFolders(path.substr(0, slash), made));
  QuietErrors errors;
  errno = 0;
  if (VSIMkdir(path.c_str(), kFolderMode) == 0) {
    if (made)
      made->push_back(path);
    return {};
  }
  const int error = errno;
  return isFolder(path) ? Status() // another thread was faster
                        : outputError("the folder '" + path + "' cannot be made", error);
}

Status writeWholeFile(const std::string& path, const void* bytes, std::size_t count) {
  QuietErrors errors;
  errno = 0;
  VSILFILE* file = openForWriting(path);
  if (!file)
    return outputError("'" + path + "' cannot be written", errno);
  const std::size_t written = count > 0 ? VSIFWriteL(bytes, 1, count, file) : 0;
  const int writeError = errno;
  const bool closed = VSIFCloseL(file) == 0;
  if (written == count && closed)
    return {};
  return outputError("'" + path + "' cannot be written", written == count ? errno : writeError);
}

Status renamePath(const std::string& from, const std::string& to) {
  QuietErrors errors;
  if (!isLocalPath(from) && isFolder(from)) { // only files can be renamed there
    QMESH_RETURN_IF_ERROR(makeFolders(to));
    for (const std::string& name : listFolder(from))
      QMESH_RETURN_IF_ERROR(renamePath(from + "/" + name, to + "/" + name));
    VSIRmdir(from.c_str());
    return {};
  }
  errno = 0;
  if (VSIRename(from.c_str(), to.c_str()) == 0)
    return {};
  return outputError("'" + from + "' cannot be moved to '" + to + "'", errno);
}

void removeTree(const std::string& path) {
  QuietErrors errors;
  // GDAL's memory unlinks a folder, too, and keeps what is in it; a link to a folder is a file.
  const bool folder = !isLocalPath(path) && isFolder(path);
  if (!folder && VSIUnlink(path.c_str()) == 0)
    return;
  for (const std::string& name : listFolder(path))
    removeTree(path + "/" + name);
  VSIRmdir(path.c_str());
}

} // namespace qmesh
