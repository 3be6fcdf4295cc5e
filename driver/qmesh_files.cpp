// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_files.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include "qmesh_errors.h"
#include "qmesh_identify.h"
#include "sink/tileset_files.h"

namespace
{

/// See QMESHHasJustDeleted().
thread_local std::string osLastDeleted; // NOLINT

CPLErr Finish(const qmesh::Status &oStatus)
{
    if (oStatus.ok())
        return CE_None;
    QMESHReportError(oStatus);
    return CE_Failure;
}

bool IsTile(const char *pszName)
{
    GDALOpenInfo oOpenInfo(QMESHStripPrefix(pszName).c_str(), GA_ReadOnly);
    return QMESHIdentifyName(&oOpenInfo).eKind == QMESHKind::Tile;
}

} // namespace

CPLErr QMESHDelete(const char *pszName)
{
    if (!IsTile(pszName))
    {
        const std::string osFolder = QMESHFolderOf(pszName);
        const qmesh::Status oStatus = qmesh::deleteTileset(osFolder);
        osLastDeleted = oStatus.ok() ? osFolder : "";
        return Finish(oStatus);
    }
    if (VSIUnlink(QMESHStripPrefix(pszName).c_str()) == 0)
        return CE_None;
    CPLError(CE_Failure, CPLE_FileIO, "QMESH: '%s' cannot be removed", pszName);
    return CE_Failure;
}

bool QMESHHasJustDeleted(const std::string &osFolder)
{
    return !osFolder.empty() && osFolder == osLastDeleted;
}

CPLErr QMESHRename(const char *pszNewName, const char *pszOldName)
{
    if (!IsTile(pszOldName))
        return Finish(qmesh::renameTileset(QMESHFolderOf(pszOldName), QMESHFolderOf(pszNewName)));
    const std::string osNew = QMESHStripPrefix(pszNewName);
    if (CPLMoveFile(osNew.c_str(), QMESHStripPrefix(pszOldName).c_str()) == 0)
        return CE_None;
    CPLError(CE_Failure, CPLE_FileIO, "QMESH: '%s' cannot be moved to '%s'", pszOldName,
             pszNewName);
    return CE_Failure;
}

CPLErr QMESHCopyFiles(const char *pszNewName, const char *pszOldName)
{
    if (!IsTile(pszOldName))
        return Finish(qmesh::copyTileset(QMESHFolderOf(pszOldName), QMESHFolderOf(pszNewName)));
    const std::string osNew = QMESHStripPrefix(pszNewName);
    if (CPLCopyFile(osNew.c_str(), QMESHStripPrefix(pszOldName).c_str()) == 0)
        return CE_None;
    CPLError(CE_Failure, CPLE_FileIO, "QMESH: '%s' cannot be copied to '%s'", pszOldName,
             pszNewName);
    return CE_Failure;
}
