// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <limits>

#include <ogr_geometry.h>

#include "qmesh_errors.h"
#include "qmesh_layer.h"
#include "surface/surface_raster.h"

using qmesh::TileId;
using qmesh::TileMesh;
using qmesh::Tileset;

namespace
{

/// Decoded positions of a tile's vertices.
class Places
{
  public:
    Places(const Tileset &oSet, const QMESHTileContent &oContent)
        : m_oBox(oSet.scheme().box(oContent.oTile)), m_oMesh(*oContent.poMesh)
    {
    }

    OGRPoint Vertex(size_t i) const
    {
        return OGRPoint(Between(m_oBox.west, m_oBox.east, m_oMesh.u[i]),
                        Between(m_oBox.south, m_oBox.north, m_oMesh.v[i]),
                        qmesh::decodedHeight(m_oMesh.header, m_oMesh.q[i]));
    }

    size_t Triangles() const { return m_oMesh.triangleCount(); }

    OGRPoint Corner(size_t iTriangle, size_t iCorner) const
    {
        return Vertex(m_oMesh.indices[3 * iTriangle + iCorner]);
    }

    std::unique_ptr<OGRPolygon> Polygon(size_t iTriangle) const
    {
        auto poPolygon = std::make_unique<OGRPolygon>();
        auto poRing = std::make_unique<OGRLinearRing>();
        for (const size_t iCorner : {0, 1, 2, 0})
        {
            const OGRPoint oCorner = Corner(iTriangle, iCorner);
            poRing->addPoint(&oCorner);
        }
        poPolygon->addRingDirectly(poRing.release());
        return poPolygon;
    }

  private:
    /// Exactly the border at both ends, so that neighbours agree.
    static double Between(double dfLow, double dfHigh, std::uint16_t n)
    {
        return n == 32767 ? dfHigh : dfLow + (dfHigh - dfLow) * n / 32767;
    }

    qmesh::GeoBox m_oBox;
    const TileMesh &m_oMesh;
};

class TinMaker final : public QMESHFeatureMaker
{
  public:
    explicit TinMaker(const Tileset &oSet) : QMESHFeatureMaker("triangles", wkbTINZ, oSet) {}

    std::unique_ptr<OGRFeature> Make(const QMESHTileContent &oContent, size_t) override
    {
        auto poFeature = NewFeature(oContent.oTile);
        if (oContent.poMesh == nullptr)
            return poFeature;
        const Places oPlaces(m_oSet, oContent);
        auto poTin = std::make_unique<OGRTriangulatedSurface>();
        for (size_t i = 0; i < oPlaces.Triangles(); ++i)
            poTin->addGeometryDirectly(
                new OGRTriangle(oPlaces.Corner(i, 0), oPlaces.Corner(i, 1), oPlaces.Corner(i, 2)));
        SetGeometry(*poFeature, std::move(poTin));
        return poFeature;
    }
};

class MultiPolygonMaker final : public QMESHFeatureMaker
{
  public:
    explicit MultiPolygonMaker(const Tileset &oSet)
        : QMESHFeatureMaker("triangles", wkbMultiPolygon25D, oSet)
    {
    }

    std::unique_ptr<OGRFeature> Make(const QMESHTileContent &oContent, size_t) override
    {
        auto poFeature = NewFeature(oContent.oTile);
        if (oContent.poMesh == nullptr)
            return poFeature;
        const Places oPlaces(m_oSet, oContent);
        auto poAll = std::make_unique<OGRMultiPolygon>();
        for (size_t i = 0; i < oPlaces.Triangles(); ++i)
            poAll->addGeometryDirectly(oPlaces.Polygon(i).release());
        SetGeometry(*poFeature, std::move(poAll));
        return poFeature;
    }
};

class PolygonMaker final : public QMESHFeatureMaker
{
  public:
    explicit PolygonMaker(const Tileset &oSet) : QMESHFeatureMaker("triangles", wkbPolygon25D, oSet)
    {
    }

    bool OnePerTile() const override { return false; }

    size_t Count(const QMESHTileContent &oContent) const override
    {
        return oContent.poMesh == nullptr ? 0 : oContent.poMesh->triangleCount();
    }

    std::unique_ptr<OGRFeature> Make(const QMESHTileContent &oContent, size_t iItem) override
    {
        auto poFeature = NewFeature(oContent.oTile);
        SetGeometry(*poFeature, Places(m_oSet, oContent).Polygon(iItem));
        return poFeature;
    }
};

class VertexMaker final : public QMESHFeatureMaker
{
  public:
    explicit VertexMaker(const Tileset &oSet) : QMESHFeatureMaker("vertices", wkbPoint25D, oSet)
    {
        AddField("height", OFTReal);
    }

    bool OnePerTile() const override { return false; }

    size_t Count(const QMESHTileContent &oContent) const override
    {
        return oContent.poMesh == nullptr ? 0 : oContent.poMesh->vertexCount();
    }

    std::unique_ptr<OGRFeature> Make(const QMESHTileContent &oContent, size_t iItem) override
    {
        auto poFeature = NewFeature(oContent.oTile);
        auto poPoint = std::make_unique<OGRPoint>(Places(m_oSet, oContent).Vertex(iItem));
        poFeature->SetField("height", poPoint->getZ());
        SetGeometry(*poFeature, std::move(poPoint));
        return poFeature;
    }
};

/// Footprints. Tiles are read only when a field wants to know what is in them.
class TileMaker final : public QMESHFeatureMaker
{
  public:
    explicit TileMaker(const Tileset &oSet) : QMESHFeatureMaker("tiles", wkbPolygon, oSet)
    {
        for (const char *pszName : {"vertices", "triangles"})
            AddField(pszName, OFTInteger);
        AddField("bytes", OFTInteger64);
        for (const char *pszName : {"min_height", "max_height", "error"})
            AddField(pszName, OFTReal);
    }

    bool NeedsMesh() const override { return false; }

    std::unique_ptr<OGRFeature> Make(const QMESHTileContent &oContent, size_t) override
    {
        const TileId &oTile = oContent.oTile;
        auto poFeature = NewFeature(oTile);
        const qmesh::GeoBox oBox = m_oSet.scheme().box(oTile);
        auto poPolygon = std::make_unique<OGRPolygon>();
        auto poRing = std::make_unique<OGRLinearRing>();
        poRing->addPoint(oBox.west, oBox.south);
        poRing->addPoint(oBox.east, oBox.south);
        poRing->addPoint(oBox.east, oBox.north);
        poRing->addPoint(oBox.west, oBox.north);
        poRing->addPoint(oBox.west, oBox.south);
        poPolygon->addRingDirectly(poRing.release());
        SetGeometry(*poFeature, std::move(poPolygon));
        for (const auto &oLevel : m_oSet.layer().levels)
            if (oLevel.zoom == oTile.z)
                poFeature->SetField("error", oLevel.errorReached);
        if (WantsContent())
            DescribeContent(oTile, *poFeature);
        return poFeature;
    }

  private:
    bool WantsContent() const
    {
        for (const char *pszName : {"vertices", "triangles", "bytes", "min_height", "max_height"})
            if (!Defn()->GetFieldDefn(Defn()->GetFieldIndex(pszName))->IsIgnored())
                return true;
        return false;
    }

    /// What cannot be read stays null; a damaged tile is a warning, for this layer is where one
    /// looks for such.
    void DescribeContent(const TileId &oTile, OGRFeature &oFeature) const
    {
        const auto oBytes = m_oSet.readBytes(oTile);
        if (oBytes.ok() && !*oBytes)
            return;
        if (oBytes.ok())
            oFeature.SetField("bytes", static_cast<GIntBig>((*oBytes)->size()));
        const qmesh::Result<TileMesh> oMesh =
            oBytes.ok() ? m_oSet.decode(oTile, **oBytes) : oBytes.status();
        if (!oMesh.ok())
        {
            QMESHReportWarning(oMesh.status().message());
            return;
        }
        oFeature.SetField("vertices", static_cast<int>(oMesh->vertexCount()));
        oFeature.SetField("triangles", static_cast<int>(oMesh->triangleCount()));
        oFeature.SetField("min_height", double(oMesh->header.minHeight));
        oFeature.SetField("max_height", double(oMesh->header.maxHeight));
    }
};

std::unique_ptr<QMESHFeatureMaker> TriangleMaker(const Tileset &oSet, QMESHGeometry eGeometry)
{
    switch (eGeometry)
    {
        case QMESHGeometry::Tin:
            return std::make_unique<TinMaker>(oSet);
        case QMESHGeometry::MultiPolygon:
            return std::make_unique<MultiPolygonMaker>(oSet);
        case QMESHGeometry::Polygons:
            return std::make_unique<PolygonMaker>(oSet);
        case QMESHGeometry::Points:
            break;
    }
    return nullptr;
}

} // namespace

QMESHFeatureMaker::QMESHFeatureMaker(const char *pszName, OGRwkbGeometryType eType,
                                     const Tileset &oSet)
    : m_oSet(oSet), m_poDefn(new OGRFeatureDefn(pszName))
{
    m_poDefn->Reference();
    m_poDefn->SetGeomType(eType);
    auto *poSRS = new OGRSpatialReference();
    poSRS->SetFromUserInput("EPSG:4326");
    poSRS->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    m_poDefn->GetGeomFieldDefn(0)->SetSpatialRef(poSRS);
    poSRS->Release();
    for (const char *pszField : {"zoom", "x", "y"})
        AddField(pszField, OFTInteger);
}

QMESHFeatureMaker::~QMESHFeatureMaker()
{
    m_poDefn->Release();
}

void QMESHFeatureMaker::AddField(const char *pszName, OGRFieldType eType)
{
    OGRFieldDefn oField(pszName, eType);
    m_poDefn->AddFieldDefn(&oField);
}

std::unique_ptr<OGRFeature> QMESHFeatureMaker::NewFeature(const TileId &oTile) const
{
    auto poFeature = std::make_unique<OGRFeature>(m_poDefn);
    poFeature->SetField(0, oTile.z);
    poFeature->SetField(1, static_cast<int>(oTile.x));
    poFeature->SetField(2, static_cast<int>(oTile.y));
    return poFeature;
}

void QMESHFeatureMaker::SetGeometry(OGRFeature &oFeature,
                                    std::unique_ptr<OGRGeometry> poGeometry) const
{
    if (m_poDefn->IsGeometryIgnored())
        return;
    poGeometry->assignSpatialReference(m_poDefn->GetGeomFieldDefn(0)->GetSpatialRef());
    oFeature.SetGeometryDirectly(poGeometry.release());
}

std::vector<std::unique_ptr<OGRLayer>> QMESHMakeLayers(qmesh::TileCache &oCache, int nZoom,
                                                       QMESHGeometry eGeometry)
{
    const Tileset &oSet = oCache.set();
    std::vector<std::unique_ptr<OGRLayer>> apoLayers;
    const auto Add = [&](std::unique_ptr<QMESHFeatureMaker> poMaker)
    { apoLayers.push_back(std::make_unique<QMESHLayer>(oCache, nZoom, std::move(poMaker))); };
    if (auto poMaker = TriangleMaker(oSet, eGeometry))
        Add(std::move(poMaker));
    Add(std::make_unique<VertexMaker>(oSet));
    Add(std::make_unique<TileMaker>(oSet));
    return apoLayers;
}
