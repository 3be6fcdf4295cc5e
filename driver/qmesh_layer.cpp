// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_layer.h"

#include <algorithm>
#include <cmath>

#include "qmesh_errors.h"
#include "tileset/terrain_raster.h"

using qmesh::Result;
using qmesh::Scheme;
using qmesh::TileId;
using qmesh::TileRange;
using qmesh::Tileset;

namespace
{

/// The tiles that a box in degrees touches; nothing where it touches none.
std::optional<TileRange> TilesTouching(const OGREnvelope &oBox, const Scheme &oScheme, int nZoom)
{
    // A margin for boxes that end on a tile's border.
    constexpr double dfMargin = 1e-9;
    const double dfColumns = oScheme.tilesX(nZoom), dfRows = oScheme.tilesY(nZoom);
    const auto Fraction = [&oScheme](double dfLatitude)
    { return oScheme.fractionY(std::clamp(dfLatitude, -90.0, 90.0)); };
    const double dfWest = std::floor((oScheme.fractionX(oBox.MinX) - dfMargin) * dfColumns);
    const double dfEast = std::floor((oScheme.fractionX(oBox.MaxX) + dfMargin) * dfColumns);
    const double dfSouth = std::floor((Fraction(oBox.MinY) - dfMargin) * dfRows);
    const double dfNorth = std::floor((Fraction(oBox.MaxY) + dfMargin) * dfRows);
    if (!(dfEast >= 0 && dfWest < dfColumns && dfNorth >= 0 && dfSouth < dfRows))
        return std::nullopt;
    const auto Within = [](double dfTile, double dfCount)
    { return static_cast<std::uint32_t>(std::clamp(dfTile, 0.0, dfCount - 1)); };
    return TileRange{Within(dfWest, dfColumns), Within(dfSouth, dfRows), Within(dfEast, dfColumns),
                     Within(dfNorth, dfRows)};
}

TileRange WholeLevel(const Scheme &oScheme, int nZoom)
{
    return {0, 0, oScheme.tilesX(nZoom) - 1, oScheme.tilesY(nZoom) - 1};
}

} // namespace

QMESHTileCursor::QMESHTileCursor(std::vector<TileRange> aoRanges, const TileRange &oWindow)
    : m_aoRanges(std::move(aoRanges)), m_oWindow(oWindow)
{
}

bool QMESHTileCursor::EnterRange()
{
    for (; m_iRange < m_aoRanges.size(); ++m_iRange)
    {
        const TileRange &oRange = m_aoRanges[m_iRange];
        m_oCut = {std::max(oRange.x0, m_oWindow.x0), std::max(oRange.y0, m_oWindow.y0),
                  std::min(oRange.x1, m_oWindow.x1), std::min(oRange.y1, m_oWindow.y1)};
        if (m_oCut.x0 > m_oCut.x1 || m_oCut.y0 > m_oCut.y1)
            continue;
        m_nX = m_oCut.x0;
        m_nY = m_oCut.y0;
        ++m_iRange;
        return true;
    }
    return false;
}

std::optional<TileRange> QMESHTileCursor::Next()
{
    if (!m_bInside && !EnterRange())
        return std::nullopt;
    const TileRange oHere{m_nX, m_nY, m_nX, m_nY};
    m_bInside = true;
    if (m_nX < m_oCut.x1)
        ++m_nX;
    else if (m_nY < m_oCut.y1)
    {
        m_nX = m_oCut.x0;
        ++m_nY;
    }
    else
        m_bInside = false;
    return oHere;
}

QMESHLayer::QMESHLayer(qmesh::TileCache &oCache, int nZoom,
                       std::unique_ptr<QMESHFeatureMaker> poMaker)
    : m_oCache(oCache), m_nZoom(nZoom), m_poMaker(std::move(poMaker))
{
    SetDescription(m_poMaker->Defn()->GetName());
}

std::vector<TileRange> QMESHLayer::Ranges() const
{
    const Tileset &oSet = m_oCache.set();
    if (m_nZoom <= oSet.available().maxZoom())
        return oSet.available().ranges(m_nZoom);
    const auto oTiles = qmesh::rasterTiles(oSet, m_nZoom);
    return oTiles ? std::vector<TileRange>{*oTiles} : std::vector<TileRange>();
}

void QMESHLayer::ResetReading()
{
    m_bStarted = false;
    m_nItems = m_iItem = 0;
}

bool QMESHLayer::Load(const TileId &oTile)
{
    m_oContent = {oTile, nullptr};
    m_iItem = m_nItems = 0;
    if (m_poMaker->NeedsMesh())
    {
        const Result<qmesh::MeshPtr> oMesh = m_oCache.mesh(oTile);
        if (!oMesh.ok())
        {
            QMESHReportError(oMesh.status());
            return false;
        }
        m_oContent.poMesh = *oMesh;
    }
    m_nItems = m_poMaker->Count(m_oContent);
    if (m_poMaker->OnePerTile() || m_nItems >> ItemBits() == 0)
        return true;
    CPLError(CE_Failure, CPLE_NotSupported,
             "QMESH: '%s' has more features than there are FIDs for a tile of zoom %d",
             m_oCache.set().tilePath(oTile).c_str(), oTile.z);
    m_nItems = 0;
    return false;
}

/// The next tile that meets the filter; false at the end or with an error.
bool QMESHLayer::LoadNext()
{
    if (!m_bStarted)
    {
        const Scheme oScheme = m_oCache.set().scheme();
        const auto oWindow = m_poFilterGeom == nullptr
                                 ? WholeLevel(oScheme, m_nZoom)
                                 : TilesTouching(m_sFilterEnvelope, oScheme, m_nZoom);
        m_oCursor = oWindow ? QMESHTileCursor(Ranges(), *oWindow) : QMESHTileCursor();
        m_bStarted = true;
    }
    const auto oPlace = m_oCursor.Next();
    return oPlace && Load({m_nZoom, oPlace->x0, oPlace->y0});
}

OGRFeature *QMESHLayer::GetNextFeature()
{
    while (true)
    {
        while (m_iItem == m_nItems)
            if (!LoadNext())
                return nullptr;
        std::unique_ptr<OGRFeature> poFeature(MakeFeature(m_iItem++));
        if ((m_poFilterGeom == nullptr || FilterGeometry(poFeature->GetGeometryRef())) &&
            (m_poAttrQuery == nullptr || m_poAttrQuery->Evaluate(poFeature.get())))
            return poFeature.release();
    }
}

OGRFeature *QMESHLayer::MakeFeature(size_t iItem)
{
    std::unique_ptr<OGRFeature> poFeature = m_poMaker->Make(m_oContent, iItem);
    poFeature->SetFID(FidOf(m_oContent.oTile, iItem));
    return poFeature.release();
}

int QMESHLayer::ItemBits() const
{
    return m_poMaker->OnePerTile() ? 0 : std::min(22, 63 - (2 * m_nZoom + 1));
}

GIntBig QMESHLayer::FidOf(const TileId &oTile, size_t iItem) const
{
    const GIntBig nTile =
        GIntBig(oTile.y) * m_oCache.set().scheme().tilesX(m_nZoom) + GIntBig(oTile.x);
    return (nTile << ItemBits()) + static_cast<GIntBig>(iItem);
}

OGRFeature *QMESHLayer::GetFeature(GIntBig nFID)
{
    const Scheme oScheme = m_oCache.set().scheme();
    const GIntBig nTile = nFID >> ItemBits();
    const GIntBig nColumns = oScheme.tilesX(m_nZoom);
    if (nFID < 0 || nTile / nColumns >= oScheme.tilesY(m_nZoom))
        return nullptr;
    const TileId oTile{m_nZoom, static_cast<std::uint32_t>(nTile % nColumns),
                       static_cast<std::uint32_t>(nTile / nColumns)};
    const auto iItem = static_cast<size_t>(nFID - (nTile << ItemBits()));
    if (!m_oCache.set().mayHave(oTile))
        return nullptr;
    // The place of the reading cursor stays.
    const QMESHTileContent oContent = m_oContent;
    const size_t iKept = m_iItem, nKept = m_nItems;
    OGRFeature *poFeature = Load(oTile) && iItem < m_nItems ? MakeFeature(iItem) : nullptr;
    m_oContent = oContent;
    m_iItem = iKept;
    m_nItems = nKept;
    return poFeature;
}

GIntBig QMESHLayer::GetFeatureCount(int bForce)
{
    if (m_poFilterGeom != nullptr || m_poAttrQuery != nullptr)
        return OGRLayer::GetFeatureCount(bForce);
    if (m_nCount < 0 && m_poMaker->OnePerTile())
    {
        m_nCount = 0;
        for (const TileRange &oRange : Ranges())
            m_nCount += static_cast<GIntBig>(oRange.count());
    }
    if (m_nCount < 0 && bForce)
        m_nCount = CountItems();
    return m_nCount;
}

/// Features of all tiles; -1 with an error.
GIntBig QMESHLayer::CountItems()
{
    QMESHTileCursor oCursor(Ranges(), WholeLevel(m_oCache.set().scheme(), m_nZoom));
    GIntBig nCount = 0;
    while (const auto oPlace = oCursor.Next())
    {
        const TileId oTile{m_nZoom, oPlace->x0, oPlace->y0};
        const Result<qmesh::MeshPtr> oMesh = m_oCache.mesh(oTile);
        if (!oMesh.ok())
        {
            QMESHReportError(oMesh.status());
            return -1;
        }
        nCount += static_cast<GIntBig>(m_poMaker->Count({oTile, *oMesh}));
    }
    return nCount;
}

OGRErr QMESHLayer::Extent(OGREnvelope *psExtent) const
{
    const Scheme oScheme = m_oCache.set().scheme();
    *psExtent = OGREnvelope();
    for (const TileRange &oRange : Ranges())
    {
        const std::uint32_t nColumns = oScheme.tilesX(m_nZoom);
        const bool bRound = oRange.x1 >= nColumns;
        const qmesh::GeoBox oFirst = oScheme.box({m_nZoom, bRound ? 0 : oRange.x0, oRange.y0});
        const qmesh::GeoBox oLast =
            oScheme.box({m_nZoom, bRound ? nColumns - 1 : oRange.x1, oRange.y1});
        psExtent->Merge(oFirst.west, oFirst.south);
        psExtent->Merge(oLast.east, oLast.north);
    }
    return psExtent->IsInit() ? OGRERR_NONE : OGRERR_FAILURE;
}

#if QMESH_HAS_LAYER_HOOKS
OGRErr QMESHLayer::IGetExtent(int, OGREnvelope *psExtent, bool)
{
    return Extent(psExtent);
}
#else
OGRErr QMESHLayer::GetExtent(OGREnvelope *psExtent, int)
{
    return Extent(psExtent);
}

OGRErr QMESHLayer::GetExtent(int iGeomField, OGREnvelope *psExtent, int bForce)
{
    return iGeomField == 0 ? Extent(psExtent) : OGRLayer::GetExtent(iGeomField, psExtent, bForce);
}
#endif

QMESH_CONST_GETTER OGRFeatureDefn *QMESHLayer::GetLayerDefn() QMESH_CONST_GETTER
{
    return m_poMaker->Defn();
}

int QMESHLayer::TestCapability(const char *pszCapability) QMESH_CONST_GETTER
{
    if (EQUAL(pszCapability, OLCFastFeatureCount))
        return m_poFilterGeom == nullptr && m_poAttrQuery == nullptr &&
               (m_nCount >= 0 || m_poMaker->OnePerTile());
    for (const char *pszHave : {OLCRandomRead, OLCFastGetExtent, OLCFastSpatialFilter,
                                OLCIgnoreFields, OLCStringsAsUTF8, OLCZGeometries})
        if (EQUAL(pszCapability, pszHave))
            return TRUE;
    return FALSE;
}
