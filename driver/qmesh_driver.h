// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

/// Registers the driver QMESH with GDAL's driver manager; nothing happens where it is there
/// already.
void QMESHRegister();
