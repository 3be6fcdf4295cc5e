// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "vsi/folder_lock.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cpl_vsi.h>

#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

/// True where `file` is what `path` names: the one who held the lock before may have removed it.
bool isStill(int file, const std::string& path) {
  struct stat mine {};
  struct stat there {};
  return fstat(file, &mine) == 0 && stat(path.c_str(), &there) == 0 &&
         mine.st_ino == there.st_ino && mine.st_dev == there.st_dev;
}

std::string holderOf(int file) {
  char text[32] = {};
  const ssize_t count = pread(file, text, sizeof text - 1, 0);
  const std::string number(text, count > 0 ? std::size_t(count) : 0);
  return number.empty() ? "another process" : "process " + number.substr(0, number.find('\n'));
}

} // namespace

Status FolderLock::acquire(const std::string& path) {
  const std::string text = std::to_string(getpid()) + "\n";
  if (!isLocalPath(path)) {
    QMESH_RETURN_IF_ERROR(writeWholeFile(path, text.data(), text.size()));
    path_ = path;
    return {};
  }
  for (;;) {
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0)
      return outputError("'" + path + "' cannot be written", errno);
    if (flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const std::string holder = holderOf(file);
      close(file);
      return {Code::output, "another run (" + holder + ") is writing to this folder ('" + path +
                                "' is locked); wait for it or choose another output"};
    }
    if (!isStill(file, path)) {
      close(file);
      continue;
    }
    path_ = path;
    file_ = file;
    if (ftruncate(file, 0) != 0 ||
        pwrite(file, text.data(), text.size(), 0) != ssize_t(text.size())) {
      const int error = errno;
      release();
      return outputError("'" + path + "' cannot be written", error);
    }
    return {};
  }
}

void FolderLock::release() {
  if (path_.empty())
    return;
  VSIUnlink(path_.c_str());
  if (file_ >= 0)
    close(file_);
  file_ = -1;
  path_.clear();
}

} // namespace qmesh
