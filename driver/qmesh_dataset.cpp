// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_dataset.h"

#include <algorithm>
#include <climits>
#include <cmath>

#include <cpl_string.h>

#include "base/text.h"
#include "geo/ellipsoid.h"
#include "qmesh_errors.h"
#include "qmesh_identify.h"
#include "qmesh_layer.h"
#include "qmesh_rasterband.h"

using qmesh::Code;
using qmesh::RasterWindow;
using qmesh::Registration;
using qmesh::Result;
using qmesh::Status;
using qmesh::TileRange;
using qmesh::Tileset;

namespace
{

/// Of sets whose layer.json does not say how many the maker had: as many as map tiles have.
constexpr int nForeignCells = 256;

bool IsCellCount(int nCells)
{
    return nCells >= 8 && nCells <= 1024 && (nCells & (nCells - 1)) == 0;
}

/// Whether a raster of so many tiles can be addressed by GDAL.
bool Fits(const TileRange &oTiles, int nCells)
{
    const auto Size = [nCells](std::uint32_t nFirst, std::uint32_t nLast)
    { return (std::int64_t(nLast) - nFirst + 1) * nCells + 1; };
    return Size(oTiles.x0, oTiles.x1) <= INT_MAX && Size(oTiles.y0, oTiles.y1) <= INT_MAX;
}

} // namespace

GDALDataset *QMESHDataset::Open(GDALOpenInfo *poOpenInfo)
{
    const QMESHName oName = QMESHIdentifyName(poOpenInfo);
    if (oName.eKind == QMESHKind::Other)
        return nullptr;
    if (poOpenInfo->eAccess == GA_Update)
    {
        // Vector programs try this first and are content with reading.
        if ((poOpenInfo->nOpenFlags & GDAL_OF_VECTOR) == 0)
            CPLError(CE_Failure, CPLE_NotSupported,
                     "QMESH: '%s' cannot be changed in place: open it read-only, or make it anew",
                     poOpenInfo->pszFilename);
        return nullptr;
    }
    Result<Tileset> oSet = oName.eKind == QMESHKind::Set ? Tileset::open(oName.osPath)
                                                         : Tileset::openTile(oName.osPath);
    if (!oSet.ok())
    {
        QMESHReportError(oSet.status());
        return nullptr;
    }
    return OpenSet(poOpenInfo, std::move(*oSet));
}

QMESHDataset *QMESHDataset::OpenSet(const GDALOpenInfo *poOpenInfo, Tileset oSet)
{
    const Result<QMESHOpenOptions> oOptions = QMESHParseOpenOptions(poOpenInfo->papszOpenOptions);
    if (!oOptions.ok())
    {
        QMESHReportError(oOptions.status());
        return nullptr;
    }
    std::unique_ptr<QMESHDataset> poDS(new QMESHDataset(std::move(oSet), *oOptions));
    poDS->SetDescription(poOpenInfo->pszFilename);
    Status oStatus = poDS->ChooseZoom();
    if (oStatus.ok() && (poOpenInfo->nOpenFlags & GDAL_OF_RASTER) != 0)
        oStatus = poDS->OpenRaster();
    if (!oStatus.ok())
    {
        QMESHReportError(oStatus);
        return nullptr;
    }
    if ((poOpenInfo->nOpenFlags & GDAL_OF_VECTOR) != 0)
        poDS->OpenVector();
    poDS->SetMetadataOfSet();
    return poDS.release();
}

QMESHDataset::QMESHDataset(Tileset oSet, const QMESHOpenOptions &oOptions)
    : m_oSet(std::move(oSet)), m_oOptions(oOptions), m_oCache(m_oSet)
{
    const int nOwn = m_oSet.layer().cellsPerTile;
    m_nCells = IsCellCount(nOwn) ? nOwn : nForeignCells;
    m_oRasterSRS.SetFromUserInput(m_oSet.scheme().crs());
    m_oRasterSRS.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    eAccess = GA_ReadOnly;
}

QMESHDataset::~QMESHDataset() = default;

/// The one asked for; else the deepest that is known and small enough for a raster.
Status QMESHDataset::ChooseZoom()
{
    const std::string osPath =
        m_oSet.singleTile() ? m_oSet.tilePath(*m_oSet.singleTile()) : m_oSet.layerPath();
    if (m_oOptions.oZoom)
    {
        m_nZoom = *m_oOptions.oZoom;
        if (qmesh::rasterTiles(m_oSet, m_nZoom))
            return {};
        return {Code::usage, "'" + osPath + "' has no tiles of zoom " + std::to_string(m_nZoom)};
    }
    if (m_oSet.singleTile())
    {
        m_nZoom = m_oSet.singleTile()->z;
        const Result<qmesh::MeshPtr> oMesh = m_oCache.mesh(*m_oSet.singleTile());
        return oMesh.ok() ? Status() : oMesh.status();
    }
    for (m_nZoom = m_oSet.available().maxZoom(); m_nZoom >= 0; --m_nZoom)
    {
        const auto oTiles = qmesh::rasterTiles(m_oSet, m_nZoom);
        if (oTiles && Fits(*oTiles, m_nCells))
            return {};
    }
    return {Code::input, "'" + osPath + "' lists no tiles"};
}

RasterWindow QMESHDataset::WindowOf(const TileRange &oTiles) const
{
    const int nShared = m_oOptions.eRegistration == Registration::node ? 1 : 0;
    const std::int64_t nRows = m_oSet.scheme().tilesY(m_nZoom);
    RasterWindow oWindow;
    oWindow.column = std::int64_t(oTiles.x0) * m_nCells;
    oWindow.row = (nRows - 1 - oTiles.y1) * m_nCells;
    oWindow.width = static_cast<int>((oTiles.x1 - oTiles.x0 + 1) * m_nCells + nShared);
    oWindow.height = static_cast<int>((oTiles.y1 - oTiles.y0 + 1) * m_nCells + nShared);
    return oWindow;
}

Status QMESHDataset::OpenRaster()
{
    const TileRange oTiles = *qmesh::rasterTiles(m_oSet, m_nZoom);
    if (!Fits(oTiles, m_nCells))
        return {Code::usage, "zoom " + std::to_string(m_nZoom) +
                                 " has more columns or rows than a "
                                 "raster can have: choose a smaller one with the open option ZOOM"};
    m_poRaster = std::make_unique<qmesh::TerrainRaster>(m_oCache, m_nCells,
                                                        m_oOptions.eRegistration, m_oOptions.eFill);
    const RasterWindow oWindow = WindowOf(oTiles);
    nRasterXSize = oWindow.width;
    nRasterYSize = oWindow.height;
    SetGeoTransformOf(oTiles);
    SetBand(1, new QMESHRasterBand(this, m_nZoom, oWindow));
    if (m_oOptions.eRegistration == Registration::cell)
        AddOverviews(oWindow);
    return {};
}

/// A coarser level is an overview as long as its cells fit the raster exactly.
void QMESHDataset::AddOverviews(const RasterWindow &oWindow)
{
    auto *poBand = static_cast<QMESHRasterBand *>(GetRasterBand(1));
    RasterWindow oCoarse = oWindow;
    for (int nZoom = m_nZoom - 1; nZoom >= 0 && !m_oSet.singleTile(); --nZoom)
    {
        if (oCoarse.column % 2 || oCoarse.row % 2 || oCoarse.width % 2 || oCoarse.height % 2)
            break;
        oCoarse = {oCoarse.column / 2, oCoarse.row / 2, oCoarse.width / 2, oCoarse.height / 2};
        if (!qmesh::rasterTiles(m_oSet, nZoom))
            break;
        poBand->AddOverview(std::make_unique<QMESHRasterBand>(this, nZoom, oCoarse));
    }
}

void QMESHDataset::SetGeoTransformOf(const TileRange &oTiles)
{
    const qmesh::Scheme oScheme = m_oSet.scheme();
    const bool bGeodetic = oScheme.profile() == qmesh::Profile::geodetic;
    const double dfHalfWidth = bGeodetic ? 180.0 : qmesh::wgs84::kPi * qmesh::wgs84::kSemiMajor;
    const double dfHalfHeight = bGeodetic ? 90.0 : dfHalfWidth;
    const double dfTileX = 2 * dfHalfWidth / oScheme.tilesX(m_nZoom);
    const double dfTileY = 2 * dfHalfHeight / oScheme.tilesY(m_nZoom);
    const double dfHalfCell = m_oOptions.eRegistration == Registration::node ? 0.5 : 0.0;
    m_adfTransform[1] = dfTileX / m_nCells;
    m_adfTransform[5] = -dfTileY / m_nCells;
    m_adfTransform[0] = oTiles.x0 * dfTileX - dfHalfWidth - dfHalfCell * m_adfTransform[1];
    m_adfTransform[3] = (oTiles.y1 + 1.0) * dfTileY - dfHalfHeight - dfHalfCell * m_adfTransform[5];
}

void QMESHDataset::SetMetadataOfSet()
{
    const qmesh::LayerJson &oLayer = m_oSet.layer();
    const auto Set = [this](const char *pszName, const std::string &osValue)
    {
        if (!osValue.empty())
            SetMetadataItem(pszName, osValue.c_str());
    };
    if (m_poRaster)
        Set(GDALMD_AREA_OR_POINT,
            m_oOptions.eRegistration == Registration::node ? GDALMD_AOP_POINT : GDALMD_AOP_AREA);
    Set("NAME", oLayer.name);
    Set("DESCRIPTION", oLayer.description);
    Set("ATTRIBUTION", oLayer.attribution);
    Set("VERSION", oLayer.version);
    Set("EXTENSIONS", qmesh::join(oLayer.extensions, ","));
    Set("SCHEME", oLayer.slippyMap ? "slippyMap" : "tms");
    Set("ZOOM", std::to_string(m_nZoom));
    Set("MAXZOOM", std::to_string(m_oSet.maxZoom()));
    Set("TILES", std::to_string(m_oSet.available().count(m_nZoom)));
    Set("GENERATOR", oLayer.generator);
    Set("METHOD", oLayer.method);
    for (const auto &oLevel : oLayer.levels)
    {
        if (oLevel.zoom != m_nZoom)
            continue;
        Set("MAX_ERROR", qmesh::formatNumber(oLevel.maxError));
        Set("ERROR_REACHED", qmesh::formatNumber(oLevel.errorReached));
        break;
    }
}

void QMESHDataset::WarnOfMissingTile()
{
    if (m_bWarned || m_oCache.firstMissing().empty())
        return;
    m_bWarned = true;
    QMESHReportWarning("'" + m_oCache.firstMissing() +
                       "' is listed in layer.json but is not there; such tiles are left out");
}

#if QMESH_HAS_GEOTRANSFORM_CLASS
CPLErr QMESHDataset::GetGeoTransform(GDALGeoTransform &oTransform) const
{
    if (nBands == 0)
        return CE_Failure;
    oTransform = GDALGeoTransform(m_adfTransform);
    return CE_None;
}
#else
CPLErr QMESHDataset::GetGeoTransform(double *padfTransform)
{
    if (nBands == 0)
        return CE_Failure;
    std::copy_n(m_adfTransform, 6, padfTransform);
    return CE_None;
}
#endif

const OGRSpatialReference *QMESHDataset::GetSpatialRef() const
{
    return nBands == 0 ? nullptr : &m_oRasterSRS;
}

/// Only what stands for the whole: a set may have millions of tiles.
char **QMESHDataset::GetFileList()
{
    const std::string osFile =
        m_oSet.singleTile() ? m_oSet.tilePath(*m_oSet.singleTile()) : m_oSet.layerPath();
    return CSLAddString(nullptr, osFile.c_str());
}

void QMESHDataset::OpenVector()
{
    m_apoLayers = QMESHMakeLayers(m_oCache, m_nZoom, m_oOptions.eGeometry);
}

int QMESHDataset::GetLayerCount() QMESH_CONST_GETTER
{
    return static_cast<int>(m_apoLayers.size());
}

QMESH_CONST_GETTER OGRLayer *QMESHDataset::GetLayer(int iLayer) QMESH_CONST_GETTER
{
    if (iLayer < 0 || iLayer >= GetLayerCount())
        return nullptr;
    return m_apoLayers[static_cast<size_t>(iLayer)].get();
}

int QMESHDataset::TestCapability(const char *pszCapability) QMESH_CONST_GETTER
{
    return EQUAL(pszCapability, ODsCZGeometries);
}
