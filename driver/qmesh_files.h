// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include <cpl_error.h>

/// GDALDriver::pfnDelete: removes the files of a set that are its own (see sink/tileset_files.h),
/// or one tile. Nothing is removed where the name is no dataset of this driver.
CPLErr QMESHDelete(const char *pszName);

/// GDALDriver::pfnRename: moves a set to a folder that is not there or empty.
CPLErr QMESHRename(const char *pszNewName, const char *pszOldName);

/// GDALDriver::pfnCopyFiles: copies a set likewise.
CPLErr QMESHCopyFiles(const char *pszNewName, const char *pszOldName);

/// Whether this thread's last QMESHDelete() was of the set in this folder. GDAL 3.11 and newer
/// delete an existing set right before they call pfnCreateCopy: files of others in its folder,
/// which stay, are then no reason to refuse the folder.
bool QMESHHasJustDeleted(const std::string &osFolder);
