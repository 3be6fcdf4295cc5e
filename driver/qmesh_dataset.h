// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "qmesh_open_options.h"
#include "qmesh_versions.h"
#include "tileset/terrain_raster.h"
#include "tileset/tile_cache.h"

// qmesh_driver.cpp registers the driver, qmesh_identify.cpp knows our names, qmesh_create_copy.cpp
// writes, qmesh_files.cpp deletes, renames and copies; qmesh_dataset.cpp and its neighbours read.

/// A quantized-mesh set as raster and vector. Not a PAM dataset: nothing is ever written beside
/// what is read, and statistics of one view (ZOOM, FILL) would be wrong in another.
class QMESHDataset final : public GDALDataset
{
  public:
    /// GDALDriver::pfnOpen: null without an error where the name is not ours or a vector
    /// program would update it.
    static GDALDataset *Open(GDALOpenInfo *poOpenInfo);

    ~QMESHDataset() override;

#if QMESH_HAS_GEOTRANSFORM_CLASS
    CPLErr GetGeoTransform(GDALGeoTransform &oTransform) const override;
#else
    CPLErr GetGeoTransform(double *padfTransform) override;
#endif
    const OGRSpatialReference *GetSpatialRef() const override;
    char **GetFileList() override;

    int GetLayerCount() QMESH_CONST_GETTER override;
    QMESH_CONST_GETTER OGRLayer *GetLayer(int iLayer) QMESH_CONST_GETTER override;
    int TestCapability(const char *pszCapability) QMESH_CONST_GETTER override;

    qmesh::TerrainRaster &Raster()
    {
        return *m_poRaster;
    }

    /// One warning for the first tile that is listed and not there.
    void WarnOfMissingTile();

  private:
    QMESHDataset(qmesh::Tileset oSet, const QMESHOpenOptions &oOptions);

    static QMESHDataset *OpenSet(const GDALOpenInfo *poOpenInfo, qmesh::Tileset oSet);
    qmesh::Status ChooseZoom();
    qmesh::Status OpenRaster();
    void AddOverviews(const qmesh::RasterWindow &oWindow);
    qmesh::RasterWindow WindowOf(const qmesh::TileRange &oTiles) const;
    void SetGeoTransformOf(const qmesh::TileRange &oTiles);
    void SetMetadataOfSet();
    void OpenVector();

    qmesh::Tileset m_oSet;
    QMESHOpenOptions m_oOptions;
    int m_nZoom = 0;
    int m_nCells = 0;
    qmesh::TileCache m_oCache;
    std::unique_ptr<qmesh::TerrainRaster> m_poRaster;
    double m_adfTransform[6] = {0, 1, 0, 0, 0, -1};
    OGRSpatialReference m_oRasterSRS;
    std::vector<std::unique_ptr<OGRLayer>> m_apoLayers;
    bool m_bWarned = false;
};
