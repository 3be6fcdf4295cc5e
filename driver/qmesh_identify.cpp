// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_identify.h"

#include <cmath>
#include <cstring>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

namespace
{

constexpr const char *pszPrefix = "QMESH:";
constexpr const char *pszLayerJson = "layer.json";

/// A layer.json says its format within so many bytes; `available`, which may be long, comes later.
constexpr int nLayerHeadBytes = 16384;

/// The header of a tile and the number of its vertices: quantized-mesh-1.0, "Header".
constexpr int nTileHeadBytes = 92;

/// Further from the Earth's centre, or higher, is no terrain; metres.
constexpr double dfFarthest = 1e8;

bool NamesTerrain(const char *pszText)
{
    return strstr(pszText, "\"quantized-mesh-1.") != nullptr && strchr(pszText, '{') != nullptr;
}

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

/// The beginning of a file as text; empty where it cannot be read.
std::string ReadHead(const std::string &osPath)
{
    VSILFILE *fp = VSIFOpenL(osPath.c_str(), "rb");
    if (fp == nullptr)
        return std::string();
    std::string osHead(nLayerHeadBytes, '\0');
    osHead.resize(VSIFReadL(&osHead[0], 1, osHead.size(), fp));
    VSIFCloseL(fp);
    return osHead;
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
    if (FileNameOf(osPath) == pszLayerJson)
        return {QMESHKind::Set, osPath};
    return {QMESHKind::Set, osPath + "/" + pszLayerJson};
}

} // namespace

std::string QMESHStripPrefix(const char *pszName)
{
    std::string osPath(STARTS_WITH_CI(pszName, pszPrefix) ? pszName + strlen(pszPrefix) : pszName);
    while (osPath.size() > 1 && osPath.back() == '/')
        osPath.pop_back();
    return osPath;
}

QMESHName QMESHIdentifyName(GDALOpenInfo *poOpenInfo)
{
    const char *pszName = poOpenInfo->pszFilename;
    if (STARTS_WITH_CI(pszName, pszPrefix))
        return PrefixedName(pszName);
    const std::string osPath = QMESHStripPrefix(pszName);
    if (poOpenInfo->bIsDirectory)
    {
        const std::string osLayer = osPath + "/" + pszLayerJson;
        if (NamesTerrain(ReadHead(osLayer).c_str()))
            return {QMESHKind::Set, osLayer};
        return {};
    }
    if (poOpenInfo->nHeaderBytes == 0)
        return {};
    if (FileNameOf(osPath) == pszLayerJson)
    {
        if (poOpenInfo->TryToIngest(nLayerHeadBytes) &&
            NamesTerrain(reinterpret_cast<const char *>(poOpenInfo->pabyHeader)))
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
