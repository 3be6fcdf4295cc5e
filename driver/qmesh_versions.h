// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <gdal_version.h>

// The one place that knows which GDAL has which signature. The driver compiles on GDAL 3.6 and on
// every newer one; whatever moved on the way has a name here. driver/README.md lists the moves.

#define QMESH_GDAL_SINCE(major, minor) (GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(major, minor, 0))

// 3.11: layers override IGetExtent and ISetSpatialFilter; GetExtent and SetSpatialFilter are not
// virtual.
#define QMESH_HAS_LAYER_HOOKS QMESH_GDAL_SINCE(3, 11)

// 3.12: the vector getters of datasets and layers are const, and give const pointers. Those of
// bands are not.
#if QMESH_GDAL_SINCE(3, 12)
#define QMESH_CONST_GETTER const
#else
#define QMESH_CONST_GETTER
#endif

// 3.12: GetGeoTransform fills a GDALGeoTransform, before six doubles.
#define QMESH_HAS_GEOTRANSFORM_CLASS QMESH_GDAL_SINCE(3, 12)

// 3.13: callbacks of a driver take their options as a CSLConstList.
#if QMESH_GDAL_SINCE(3, 13)
#define QMESH_OPTION_LIST CSLConstList
#else
#define QMESH_OPTION_LIST char **
#endif
