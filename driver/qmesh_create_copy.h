// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <gdal_priv.h>

#include "qmesh_versions.h"

/// GDALDriver::pfnCreateCopy: does what gdal2qmesh does with the same options, byte for byte. The
/// set is built beside what is there and takes its place when it is complete; after an error or a
/// cancel the output is as it was.
GDALDataset *QMESHCreateCopy(const char *pszFilename, GDALDataset *poSrcDS, int bStrict,
                             QMESH_OPTION_LIST papszOptions, GDALProgressFunc pfnProgress,
                             void *pProgressData);
