// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "vsi/vsi_read.h"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <system_error>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <cpl_vsi_error.h>

#include "vsi/quiet_errors.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

constexpr char kCurl[] = "/vsicurl/";
constexpr std::size_t kFirstChunk = std::size_t(1) << 16;

struct FileCloser {
  void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};
using FilePtr = std::unique_ptr<VSILFILE, FileCloser>;

/// The form of a /vsicurl/ path that makes the fewest requests.
std::string sparingPath(const std::string& path) {
  if (path.rfind(kCurl, 0) != 0)
    return path;
  char* url = CPLEscapeString(path.c_str() + sizeof kCurl - 1, -1, CPLES_URL);
  std::string sparing = std::string("/vsicurl?use_head=no&list_dir=no&empty_dir=yes&url=") + url;
  CPLFree(url);
  return sparing;
}

Status unreadable(const std::string& path, const std::string& reason) {
  return {Code::input, "'" + path + "' cannot be read: " + reason};
}

/// Why a file could not be opened: nothing where there simply is none.
Result<FileBytes> notOpened(const std::string& path, int error) {
  if (isLocalPath(path)) {
    if (error == ENOENT || error == ENOTDIR)
      return FileBytes();
    return unreadable(path, std::generic_category().message(error));
  }
  const int number = VSIGetLastErrorNo();
  const std::string reason = number != 0 ? VSIGetLastErrorMsg() : "";
  for (const char* missing : {"403", "404", "410"})
    if (number == VSIE_HttpError && reason.find(missing) != std::string::npos)
      return FileBytes();
  if (number == VSIE_HttpError)
    return unreadable(path, reason);
  return pathExists(path)
             ? Result<FileBytes>(unreadable(path, reason.empty() ? "reason unknown" : reason))
             : Result<FileBytes>(FileBytes());
}

/// GDAL does not say "end of file" of a compressed entry of a zip archive; its size tells, too.
bool atEnd(VSILFILE& file, std::size_t filled) {
  return VSIFEofL(&file) != 0 ||
         (VSIFSeekL(&file, 0, SEEK_END) == 0 && VSIFTellL(&file) == vsi_l_offset(filled));
}

} // namespace

Result<FileBytes> readWholeFile(const std::string& path, std::size_t maxSize) {
  QuietErrors errors;
  VSIErrorReset();
  errno = 0;
  const FilePtr file(VSIFOpenExL(sparingPath(path).c_str(), "rb", /*bSetError=*/TRUE));
  if (!file)
    return notOpened(path, errno);
  std::vector<std::uint8_t> bytes;
  std::size_t filled = 0;
  while (true) {
    bytes.resize(std::max(kFirstChunk, 2 * filled));
    const std::size_t wanted = bytes.size() - filled;
    errno = 0;
    const std::size_t got = VSIFReadL(bytes.data() + filled, 1, wanted, file.get());
    filled += got;
    if (filled > maxSize)
      return unreadable(path, "it is larger than " + std::to_string(maxSize >> 20) + " MB");
    if (got == wanted)
      continue;
    if (!atEnd(*file, filled) || !errors.firstFailure().empty())
      return unreadable(path, !errors.firstFailure().empty() ? errors.firstFailure()
                              : errno != 0 ? std::generic_category().message(errno)
                                           : "it ends before its end");
    break;
  }
  bytes.resize(filled);
  return FileBytes(std::move(bytes));
}

} // namespace qmesh
