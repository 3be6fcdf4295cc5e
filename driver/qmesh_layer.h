// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <ogrsf_frmts.h>

#include "qmesh_open_options.h"
#include "qmesh_versions.h"
#include "tileset/tile_cache.h"

/// Goes over the listed tiles of a level that meet a box, without looking at the others.
class QMESHTileCursor
{
  public:
    QMESHTileCursor() = default;
    QMESHTileCursor(std::vector<qmesh::TileRange> aoRanges, const qmesh::TileRange &oWindow);

    std::optional<qmesh::TileRange> Next();

  private:
    bool EnterRange();

    std::vector<qmesh::TileRange> m_aoRanges;
    qmesh::TileRange m_oWindow;
    size_t m_iRange = 0;
    bool m_bInside = false;
    std::uint32_t m_nX = 0, m_nY = 0;
    qmesh::TileRange m_oCut; ///< of the range, within the window
};

/// A tile whose features are being made.
struct QMESHTileContent
{
    qmesh::TileId oTile;
    qmesh::MeshPtr poMesh; ///< null where there is no file
};

/// What kind of features a layer makes of a tile.
class QMESHFeatureMaker
{
  public:
    QMESHFeatureMaker(const char *pszName, OGRwkbGeometryType eType, const qmesh::Tileset &oSet);
    virtual ~QMESHFeatureMaker();
    QMESHFeatureMaker(const QMESHFeatureMaker &) = delete;
    QMESHFeatureMaker &operator=(const QMESHFeatureMaker &) = delete;

    OGRFeatureDefn *Defn() const { return m_poDefn; }

    /// True where a tile is exactly one feature, whatever is in it.
    virtual bool OnePerTile() const { return true; }
    /// True where the mesh is needed to make the features.
    virtual bool NeedsMesh() const { return true; }
    virtual size_t Count(const QMESHTileContent &) const { return 1; }
    virtual std::unique_ptr<OGRFeature> Make(const QMESHTileContent &oContent, size_t iItem) = 0;

  protected:
    void AddField(const char *pszName, OGRFieldType eType);
    /// A feature with the fields zoom, x and y.
    std::unique_ptr<OGRFeature> NewFeature(const qmesh::TileId &oTile) const;
    /// Takes the geometry unless it is not wanted.
    void SetGeometry(OGRFeature &oFeature, std::unique_ptr<OGRGeometry> poGeometry) const;

    const qmesh::Tileset &m_oSet;

  private:
    OGRFeatureDefn *m_poDefn;
};

/// Features of the tiles of one level, in the order in which layer.json lists the tiles.
/// FID: the tile's number y * columns + x, where a tile has many features times 2^22 (less at zoom
/// 21 and deeper) plus the feature's number in the tile.
class QMESHLayer final : public OGRLayer
{
  public:
    QMESHLayer(qmesh::TileCache &oCache, int nZoom, std::unique_ptr<QMESHFeatureMaker> poMaker);

    void ResetReading() override;
    OGRFeature *GetNextFeature() override;
    OGRFeature *GetFeature(GIntBig nFID) override;
    GIntBig GetFeatureCount(int bForce) override;
    QMESH_CONST_GETTER OGRFeatureDefn *GetLayerDefn() QMESH_CONST_GETTER override;
    int TestCapability(const char *pszCapability) QMESH_CONST_GETTER override;
#if QMESH_HAS_LAYER_HOOKS
    OGRErr IGetExtent(int iGeomField, OGREnvelope *psExtent, bool bForce) override;
#else
    OGRErr GetExtent(OGREnvelope *psExtent, int bForce) override;
    OGRErr GetExtent(int iGeomField, OGREnvelope *psExtent, int bForce) override;
#endif

  private:
    bool Load(const qmesh::TileId &oTile);
    bool LoadNext();
    OGRFeature *MakeFeature(size_t iItem);
    GIntBig CountItems();
    OGRErr Extent(OGREnvelope *psExtent) const;
    int ItemBits() const;
    GIntBig FidOf(const qmesh::TileId &oTile, size_t iItem) const;
    std::vector<qmesh::TileRange> Ranges() const;

    qmesh::TileCache &m_oCache;
    int m_nZoom;
    std::unique_ptr<QMESHFeatureMaker> m_poMaker;
    bool m_bStarted = false;
    QMESHTileCursor m_oCursor;
    QMESHTileContent m_oContent;
    size_t m_iItem = 0, m_nItems = 0;
    GIntBig m_nCount = -1; ///< of all features, when it is known
};

/// The layers of a level: "triangles" (not for points), "vertices", "tiles".
std::vector<std::unique_ptr<OGRLayer>> QMESHMakeLayers(qmesh::TileCache &oCache, int nZoom,
                                                       QMESHGeometry eGeometry);
