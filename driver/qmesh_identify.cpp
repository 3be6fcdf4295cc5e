// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_identify.h"

#include <cmath>
#include <cstring>
#include <vector>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include "sink/tileset_files.h"
#include "tileset/tile_address.h"
#include "vsi/quiet_errors.h"

namespace
{

/// Enough of a layer.json to tell its format.
constexpr int nLayerHeadBytes = 16384;

/// The header of a tile and the number of its vertices: quantized-mesh-1.0, "Header".
constexpr int nTileHeadBytes = 92;

/// More vertices than any tile has; 1025 x 1025 at most here.
constexpr GUInt32 nMostVertices = 1U << 24;

/// Further from the Earth's centre, or higher, is no terrain; metres.
constexpr double dfFarthest = 1e8;

std::string FileNameOf(const std::string &osPath)
{
    const std::string osFile = osPath.substr(osPath.rfind('/') + 1);
    return osFile.substr(0, osFile.find('?')); // of a URL
}

bool IsNumber(const std::string &osText)
{
    return !osText.empty() && osText.find_first_not_of("0123456789") == std::string::npos;
}

/// Whether a name ends in zoom/column/row.terrain: without these a tile lies nowhere.
bool EndsAsTile(const std::string &osPath)
{
    const CPLStringList aosParts(CSLTokenizeString2(osPath.c_str(), "/", 0));
    const int nParts = aosParts.size();
    const std::string osFile = FileNameOf(osPath);
    const size_t nDot = osFile.rfind('.');
    return nParts >= 3 && nDot != std::string::npos && EQUAL(osFile.c_str() + nDot, ".terrain") &&
           IsNumber(osFile.substr(0, nDot)) && IsNumber(aosParts[nParts - 2]) &&
           IsNumber(aosParts[nParts - 3]);
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
/// sphere, some vertices.
bool BeginsAsTile(const GByte *pabyHead, int nBytes)
{
    if (nBytes < nTileHeadBytes)
        return false;
    for (const int nOffset : {0, 8, 16, 32, 40, 48, 56})
        if (!(std::abs(DoubleAt(pabyHead, nOffset)) < dfFarthest))
            return false;
    GUInt32 nVertices = 0;
    memcpy(&nVertices, pabyHead + nTileHeadBytes - sizeof nVertices, sizeof nVertices);
    CPL_LSBPTR32(&nVertices);
    if (nVertices < 3 || nVertices > nMostVertices)
        return false;
    const float fLow = FloatAt(pabyHead, 24);
    const float fHigh = FloatAt(pabyHead, 28);
    return std::abs(fLow) < dfFarthest && std::abs(fHigh) < dfFarthest && fLow <= fHigh;
}

/// The beginning of a compressed file, decompressed; shorter where that fails.
std::vector<GByte> UnzippedHead(const std::string &osPath)
{
    const qmesh::QuietErrors oQuiet;
    std::vector<GByte> abyHead(nTileHeadBytes);
    VSILFILE *fp = VSIFOpenL(("/vsigzip/" + osPath).c_str(), "rb");
    abyHead.resize(fp ? VSIFReadL(abyHead.data(), 1, abyHead.size(), fp) : 0);
    if (fp)
        VSIFCloseL(fp);
    return abyHead;
}

bool IsTile(const GDALOpenInfo *poOpenInfo, const std::string &osPath)
{
    const GByte *pabyHead = poOpenInfo->pabyHeader;
    const int nBytes = poOpenInfo->nHeaderBytes;
    if (nBytes < 2 || pabyHead[0] != 0x1f || pabyHead[1] != 0x8b)
        return BeginsAsTile(pabyHead, nBytes);
    const std::vector<GByte> abyHead = UnzippedHead(osPath);
    return BeginsAsTile(abyHead.data(), static_cast<int>(abyHead.size()));
}

/// Where a look costs a request.
bool IsOnServer(const std::string &osPath)
{
    return osPath.find("://") != std::string::npos;
}

/// A name that begins with the prefix is meant for this driver, whatever is there.
QMESHName PrefixedName(const char *pszName)
{
    const std::string osPath = QMESHStripPrefix(pszName);
    if (EQUAL(CPLGetExtension(FileNameOf(osPath).c_str()), "terrain") &&
        !CPLStringList(VSIReadDir(osPath.c_str())).Count())
        return {QMESHKind::Tile, osPath};
    return {QMESHKind::Set, qmesh::layerJsonPath(osPath)};
}

} // namespace

std::string QMESHStripPrefix(const char *pszName)
{
    std::string osPath(STARTS_WITH_CI(pszName, QMESHPrefix) ? pszName + strlen(QMESHPrefix)
                                                            : pszName);
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
    if (STARTS_WITH_CI(pszName, QMESHPrefix))
        return PrefixedName(pszName);
    std::string osPath = QMESHStripPrefix(pszName);
    if (poOpenInfo->bIsDirectory)
    {
        if (qmesh::holdsTileset(osPath))
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
    if (EndsAsTile(osPath) && IsTile(poOpenInfo, osPath))
        return {QMESHKind::Tile, osPath};
    return {};
}

int QMESHIdentify(GDALOpenInfo *poOpenInfo)
{
    const QMESHName oName = QMESHIdentifyName(poOpenInfo);
    if (oName.eKind == QMESHKind::Other)
        return GDAL_IDENTIFY_FALSE;
    // GDAL deletes what is identified before it writes there. Opening says best what is missing.
    VSIStatBufL sStat;
    if (STARTS_WITH_CI(poOpenInfo->pszFilename, QMESHPrefix) && !IsOnServer(oName.osPath) &&
        VSIStatExL(oName.osPath.c_str(), &sStat, VSI_STAT_EXISTS_FLAG) != 0)
        return GDAL_IDENTIFY_UNKNOWN;
    return GDAL_IDENTIFY_TRUE;
}
