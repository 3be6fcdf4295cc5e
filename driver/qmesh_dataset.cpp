// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_dataset.h"

GDALDataset *QMESHDataset::Open(GDALOpenInfo *)
{
    return nullptr;
}
