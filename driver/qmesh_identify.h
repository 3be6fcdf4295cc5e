// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include <gdal_priv.h>

/// Before any path: what follows is ours.
constexpr const char *QMESHPrefix = "QMESH:";

/// What a dataset name means to the driver.
enum class QMESHKind
{
    Other, ///< not ours
    Set,   ///< a quantized-mesh set
    Tile,  ///< one tile file
};

struct QMESHName
{
    QMESHKind eKind = QMESHKind::Other;
    std::string osPath; ///< of a set: its layer.json; of a tile: the file
};

/// Looks at a name as GDAL passes it: "QMESH:" before any path, a folder with a quantized-mesh
/// layer.json, that layer.json, a .terrain file. Reads the first bytes of one file at most.
QMESHName QMESHIdentifyName(GDALOpenInfo *poOpenInfo);

/// GDALDriver::pfnIdentify.
int QMESHIdentify(GDALOpenInfo *poOpenInfo);

/// A name without "QMESH:" and without slashes at its end.
std::string QMESHStripPrefix(const char *pszName);

/// The folder a name of a set stands for: itself, or the one its layer.json lies in.
std::string QMESHFolderOf(const char *pszName);
