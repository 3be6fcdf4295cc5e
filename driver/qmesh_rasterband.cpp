// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_rasterband.h"

#include <algorithm>
#include <cmath>

#include "qmesh_errors.h"

QMESHRasterBand::QMESHRasterBand(QMESHDataset *poDataset, int nZoom,
                                 const qmesh::RasterWindow &oWindow)
    : m_poDataset(poDataset), m_nZoom(nZoom), m_oWindow(oWindow)
{
    poDS = poDataset;
    nBand = 1;
    eAccess = GA_ReadOnly;
    eDataType = GDT_Float32;
    nRasterXSize = oWindow.width;
    nRasterYSize = oWindow.height;
    nBlockXSize = nBlockYSize = poDataset->Raster().cells();
    GDALRasterBand::SetDescription("height");
}

CPLErr QMESHRasterBand::IReadBlock(int nBlockX, int nBlockY, void *pData)
{
    const int nColumn = nBlockX * nBlockXSize;
    const int nRow = nBlockY * nBlockYSize;
    qmesh::RasterWindow oBlock;
    oBlock.column = m_oWindow.column + nColumn;
    oBlock.row = m_oWindow.row + nRow;
    oBlock.width = std::min(nBlockXSize, nRasterXSize - nColumn);
    oBlock.height = std::min(nBlockYSize, nRasterYSize - nRow);

    float *pafHeights = static_cast<float *>(pData);
    const qmesh::Status oStatus = m_poDataset->Raster().read(m_nZoom, oBlock, pafHeights);
    if (!oStatus.ok())
    {
        QMESHReportError(oStatus);
        return CE_Failure;
    }
    m_poDataset->WarnOfMissingTile();

    // Rows of a block at the raster's end are shorter than the block's.
    for (int iRow = oBlock.height - 1; iRow >= 0; --iRow)
    {
        const float *pafFrom = pafHeights + static_cast<size_t>(iRow) * oBlock.width;
        float *pafTo = pafHeights + static_cast<size_t>(iRow) * nBlockXSize;
        for (int iColumn = oBlock.width - 1; iColumn >= 0; --iColumn)
            pafTo[iColumn] =
                std::isnan(pafFrom[iColumn]) ? static_cast<float>(dfNoData) : pafFrom[iColumn];
    }
    return CE_None;
}

double QMESHRasterBand::GetNoDataValue(int *pbSuccess)
{
    if (pbSuccess != nullptr)
        *pbSuccess = TRUE;
    return dfNoData;
}

const char *QMESHRasterBand::GetUnitType()
{
    return "m";
}

int QMESHRasterBand::GetOverviewCount()
{
    return static_cast<int>(m_apoOverviews.size());
}

GDALRasterBand *QMESHRasterBand::GetOverview(int iOverview)
{
    if (iOverview < 0 || iOverview >= GetOverviewCount())
        return nullptr;
    return m_apoOverviews[static_cast<size_t>(iOverview)].get();
}
