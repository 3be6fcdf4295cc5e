// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>
#include <string>

#include <gdal_priv.h>

#include "base/status.h"
#include "tileset/terrain_raster.h"

/// What the layer "triangles" is made of.
enum class QMESHGeometry
{
    Tin,          ///< one TIN for each tile
    MultiPolygon, ///< one multipolygon for each tile
    Polygons,     ///< one polygon for each triangle
    Points,       ///< there is no such layer, only points
};

/// How a set is to be seen. The defaults are those of the reference page.
struct QMESHOpenOptions
{
    std::optional<int> oZoom; ///< the deepest one that is known, when none is given
    qmesh::Fill eFill = qmesh::Fill::nodata;
    QMESHGeometry eGeometry = QMESHGeometry::Tin;
    qmesh::Registration eRegistration = qmesh::Registration::cell;
};

/// Code::usage for a value that an option does not know. Options of other names are GDAL's to warn
/// about.
qmesh::Result<QMESHOpenOptions> QMESHParseOpenOptions(CSLConstList papszOptions);

/// The text of GDAL_DMD_OPENOPTIONLIST.
std::string QMESHOpenOptionXml();
