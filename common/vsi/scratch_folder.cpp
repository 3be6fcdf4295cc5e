// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "vsi/scratch_folder.h"

#include <cerrno>
#include <cstdlib>

#include <cpl_conv.h>

#include "vsi/vsi_files.h"

namespace qmesh {

Result<ScratchFolder> ScratchFolder::make(const std::string& work) {
  if (isLocalPath(work)) {
    QMESH_RETURN_IF_ERROR(makeFolders(work + "/scratch"));
    return ScratchFolder(work + "/scratch", false);
  }
  std::string name =
      std::string(CPLGetConfigOption("CPL_TMPDIR", CPLGetConfigOption("TMPDIR", "/tmp"))) +
      "/qmesh-XXXXXX";
  if (!mkdtemp(name.data()))
    return outputError("no temporary folder '" + name + "' can be made", errno);
  return ScratchFolder(name, true);
}

ScratchFolder::~ScratchFolder() {
  if (removed_)
    removeTree(path_);
}

} // namespace qmesh
