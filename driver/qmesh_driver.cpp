// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_driver.h"

#include <gdal_priv.h>

#include "qmesh_dataset.h"
#include "qmesh_identify.h"

void QMESHRegister()
{
    if (GDALGetDriverByName("QMESH") != nullptr)
        return;
    GDALDriver *poDriver = new GDALDriver();
    poDriver->SetDescription("QMESH");
    poDriver->SetMetadataItem(GDAL_DMD_LONGNAME, "Cesium quantized-mesh terrain");
    poDriver->SetMetadataItem(GDAL_DMD_HELPTOPIC, "drivers/raster/qmesh.html");
    poDriver->SetMetadataItem(GDAL_DMD_EXTENSION, "terrain");
    poDriver->SetMetadataItem(GDAL_DMD_EXTENSIONS, "terrain");
    poDriver->SetMetadataItem(GDAL_DCAP_RASTER, "YES");
    poDriver->SetMetadataItem(GDAL_DCAP_VIRTUALIO, "YES");
    poDriver->pfnIdentify = QMESHIdentify;
    poDriver->pfnOpen = QMESHDataset::Open;
    GetGDALDriverManager()->RegisterDriver(poDriver);
}
