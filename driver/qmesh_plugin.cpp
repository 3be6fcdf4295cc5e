// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gdal.h>

#include "qmesh_driver.h"

CPL_C_START
/// What GDAL calls when it has loaded the plugin: the only symbol it exports (gdal_QMESH.map).
void CPL_DLL GDALRegister_QMESH();
CPL_C_END

void GDALRegister_QMESH()
{
    if (GDAL_CHECK_VERSION("QMESH driver"))
        QMESHRegister();
}
