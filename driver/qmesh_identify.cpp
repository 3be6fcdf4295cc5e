// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_identify.h"

#include <cmath>
#include <cstring>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include "gdalio/set_files.h"

namespace
{

constexpr const char *pszPrefix = "QMESH:";

/// Enough of a layer.json to tell its format.
constexpr int nLayerHeadBytes = 16384;

/// The header of a tile and the number of its vertices: quantized-mesh-1.0, "Header".
constexpr int nTileHeadBytes = 92;

/// Further from the Earth's centre, or higher, is no terrain; metres.
constexpr double dfFarthest = 1e8;

std::string FileNameOf(const std::string &osPath)
{
    const std::string osFile = osPath.substr(osPath.rfind('/') + 1);
    return osFile.substr(0, osFile.find('?')); // of a URL
}

bool EndsAsTile(const std::string &osPath)
{
    const std::string osFile = FileNameOf(osPath);
    const size_t nDot = osFile.rfind('.');
    return nDot != std::string::npos && EQUAL(osFile.c_str() + nDot, ".terrain");
}

double DoubleAt(const GByte *pabyHead, int nOffset)
{
    double dfValue = 0;
    memcpy(&dfValue, pabyHead + nOffset, sizeof dfValue);
    CPL_LSBPTR64(&dfValue);
    return dfValue;
}

float FloatAt(const GByte *pabyHead, int nOffset)
{
    float fValue = 0;
    memcpy(&fValue, pabyHead + nOffset, sizeof fValue);
    CPL_LSBPTR32(&fValue);
    return fValue;
}

/// Whether an uncompressed file begins as a tile does: a centre, heights in order, a bounding
/// sphere.
bool BeginsAsTile(const GByte *pabyHead, int nBytes)
{
    if (nBytes < nTileHeadBytes)
        return false;
    for (const int nOffset : {0, 8, 16, 32, 40, 48, 56})
        if (!(std::abs(DoubleAt(pabyHead, nOffset)) < dfFarthest))
            return false;
    const float fLow = FloatAt(pabyHead, 24);
    const float fHigh = FloatAt(pabyHead, 28);
    return std::abs(fLow) < dfFarthest && std::abs(fHigh) < dfFarthest && fLow <= fHigh;
}

QMESHKind TileKind(const GDALOpenInfo *poOpenInfo)
{
    const GByte *pabyHead = poOpenInfo->pabyHeader;
    const int nBytes = poOpenInfo->nHeaderBytes;
    if (nBytes >= 2 && pabyHead[0] == 0x1f && pabyHead[1] == 0x8b)
        return QMESHKind::Maybe;
    return BeginsAsTile(pabyHead, nBytes) ? QMESHKind::Tile : QMESHKind::Other;
}

/// A name that begins with the prefix is meant for this driver, whatever is there.
QMESHName PrefixedName(const char *pszName)
{
    const std::string osPath = QMESHStripPrefix(pszName);
    if (EndsAsTile(osPath) && !CPLStringList(VSIReadDir(osPath.c_str())).Count())
        return {QMESHKind::Tile, osPath};
    if (FileNameOf(osPath) == qmesh::kLayerJsonName)
        return {QMESHKind::Set, osPath};
    return {QMESHKind::Set, osPath + "/" + qmesh::kLayerJsonName};
}

} // namespace

std::string QMESHStripPrefix(const char *pszName)
{
    std::string osPath(STARTS_WITH_CI(pszName, pszPrefix) ? pszName + strlen(pszPrefix) : pszName);
    while (osPath.size() > 1 && osPath.back() == '/')
        osPath.pop_back();
    return osPath;
}

std::string QMESHFolderOf(const char *pszName)
{
    const std::string osPath = QMESHStripPrefix(pszName);
    if (FileNameOf(osPath) != qmesh::kLayerJsonName)
        return osPath;
    const size_t nSlash = osPath.rfind('/');
    return nSlash == std::string::npos ? "." : osPath.substr(0, nSlash);
}

QMESHName QMESHIdentifyName(GDALOpenInfo *poOpenInfo)
{
    const char *pszName = poOpenInfo->pszFilename;
    if (STARTS_WITH_CI(pszName, pszPrefix))
        return PrefixedName(pszName);
    const std::string osPath = QMESHStripPrefix(pszName);
    if (poOpenInfo->bIsDirectory)
    {
        if (qmesh::isTerrainSet(osPath))
            return {QMESHKind::Set, osPath + "/" + qmesh::kLayerJsonName};
        return {};
    }
    if (poOpenInfo->nHeaderBytes == 0)
        return {};
    if (FileNameOf(osPath) == qmesh::kLayerJsonName)
    {
        if (poOpenInfo->TryToIngest(nLayerHeadBytes) &&
            qmesh::saysQuantizedMesh(reinterpret_cast<const char *>(poOpenInfo->pabyHeader)))
            return {QMESHKind::Set, osPath};
        return {};
    }
    if (EndsAsTile(osPath))
        return {TileKind(poOpenInfo), osPath};
    return {};
}

int QMESHIdentify(GDALOpenInfo *poOpenInfo)
{
    switch (QMESHIdentifyName(poOpenInfo).eKind)
    {
        case QMESHKind::Set:
        case QMESHKind::Tile:
            return GDAL_IDENTIFY_TRUE;
        case QMESHKind::Maybe:
            return GDAL_IDENTIFY_UNKNOWN;
        case QMESHKind::Other:
            break;
    }
    return GDAL_IDENTIFY_FALSE;
}
