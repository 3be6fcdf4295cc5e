// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <utility>

#include "base/status.h"

namespace qmesh {

/// A folder on a local disk for temporary files. WORK/scratch where the folder WORK is local:
/// whoever owns WORK removes it. Else a new folder where GDAL or the system have theirs
/// (CPL_TMPDIR, TMPDIR, /tmp), removed with this object.
class ScratchFolder {
 public:
  /// Code::output with the system's reason.
  static Result<ScratchFolder> make(const std::string& work);

  ScratchFolder(ScratchFolder&& other) noexcept
      : path_(std::move(other.path_)), removed_(std::exchange(other.removed_, false)) {}
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::string& path() const { return path_; }

 private:
  ScratchFolder(std::string path, bool removed) : path_(std::move(path)), removed_(removed) {}

  std::string path_;
  bool removed_; ///< at the end
};

} // namespace qmesh
