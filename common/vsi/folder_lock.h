// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "base/status.h"

namespace qmesh {

/// Holds a lock file for as long as it lives: the sign that one process works on a folder. On local
/// file systems the system lets go of it when the process dies, however it dies, so a file left
/// behind locks nobody out; elsewhere (/vsimem/) the file is made but does not lock.
class FolderLock {
 public:
  FolderLock() = default;
  ~FolderLock() { release(); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Makes and locks `path`, in a folder that exists. Code::output where another process (its
  /// number is named) has it, or it cannot be made.
  Status acquire(const std::string& path);

  /// Removes the file and lets go; harmless when nothing is held.
  void release();

 private:
  std::string path_;
  int file_ = -1;
};

} // namespace qmesh
