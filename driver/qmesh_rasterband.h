// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <vector>

#include <gdal_priv.h>

#include "qmesh_dataset.h"
#include "tileset/terrain_raster.h"

/// Heights of a level; the dataset's own level has the coarser ones as overviews.
class QMESHRasterBand final : public GDALRasterBand
{
  public:
    /// Lower than any place on Earth, and what the makers of elevation data use.
    static constexpr double dfNoData = -32768;

    QMESHRasterBand(QMESHDataset *poDataset, int nZoom, const qmesh::RasterWindow &oWindow);

    void AddOverview(std::unique_ptr<QMESHRasterBand> poBand)
    {
        m_apoOverviews.push_back(std::move(poBand));
    }

    CPLErr IReadBlock(int nBlockX, int nBlockY, void *pData) override;
    double GetNoDataValue(int *pbSuccess) override;
    const char *GetUnitType() override;
    int GetOverviewCount() override;
    GDALRasterBand *GetOverview(int iOverview) override;

  private:
    QMESHDataset *m_poDataset;
    int m_nZoom;
    qmesh::RasterWindow m_oWindow; ///< of the whole band
    std::vector<std::unique_ptr<QMESHRasterBand>> m_apoOverviews;
};
