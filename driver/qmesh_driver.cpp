// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_driver.h"

#include <gdal_priv.h>

#include "options/creation_options.h"
#include "qmesh_create_copy.h"
#include "qmesh_dataset.h"
#include "qmesh_errors.h"
#include "qmesh_files.h"
#include "qmesh_identify.h"
#include "qmesh_open_options.h"

namespace
{

#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 7, 0)
constexpr const char *pszDataTypes =
    "Byte Int8 UInt16 Int16 UInt32 Int32 UInt64 Int64 Float32 Float64";
#else
constexpr const char *pszDataTypes = "Byte UInt16 Int16 UInt32 Int32 UInt64 Int64 Float32 Float64";
#endif

} // namespace

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
    poDriver->SetMetadataItem(GDAL_DCAP_VECTOR, "YES");
    poDriver->SetMetadataItem(GDAL_DCAP_MULTIPLE_VECTOR_LAYERS, "YES");
    poDriver->SetMetadataItem(GDAL_DCAP_Z_GEOMETRIES, "YES");
    poDriver->SetMetadataItem(GDAL_DMD_SUPPORTED_SQL_DIALECTS, "OGRSQL SQLITE");
    poDriver->SetMetadataItem(GDAL_DMD_CONNECTION_PREFIX, QMESHPrefix);
    poDriver->SetMetadataItem(GDAL_DCAP_VIRTUALIO, "YES");
    poDriver->SetMetadataItem(GDAL_DMD_CREATIONDATATYPES, pszDataTypes);
    poDriver->SetMetadataItem(GDAL_DMD_CREATIONOPTIONLIST,
                              qmesh::creationOptionXml(QMESHOptionTable()).c_str());
    poDriver->SetMetadataItem(GDAL_DMD_OPENOPTIONLIST, QMESHOpenOptionXml().c_str());
    poDriver->pfnIdentify = QMESHIdentify;
    poDriver->pfnOpen = QMESHDataset::Open;
    poDriver->pfnCreateCopy = QMESHCreateCopy;
    poDriver->pfnDelete = QMESHDelete;
    poDriver->pfnRename = QMESHRename;
    poDriver->pfnCopyFiles = QMESHCopyFiles;
    GetGDALDriverManager()->RegisterDriver(poDriver);
}
