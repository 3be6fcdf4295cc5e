// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <gdal_priv.h>

// qmesh_driver.cpp registers the driver, qmesh_identify.cpp knows our names, qmesh_create_copy.cpp
// writes, qmesh_files.cpp deletes, renames and copies; qmesh_dataset.cpp and its neighbours read.

/// A quantized-mesh set as raster and vector.
class QMESHDataset
{
  public:
    /// GDALDriver::pfnOpen: null without an error where the name is not ours or is to be updated.
    static GDALDataset *Open(GDALOpenInfo *poOpenInfo);
};
