# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The GDAL driver QMESH in QGIS's own process."""

from osgeo import gdal

from . import places

NAME = "QMESH"
MISSING = (
    "GDAL's QMESH driver is not there, so QGIS cannot open the terrain. Install qmesh with its GDAL plugin, or name the "
    "folder that holds gdal_QMESH in Settings > Options > Processing > Providers > Quantized-mesh terrain."
)


def register():
    """True where the driver is there, now or already. GDAL loads plugins from GDAL_DRIVER_PATH when all drivers are
    registered; doing that again adds what is new and leaves the others alone."""
    if gdal.GetDriverByName(NAME):
        return True
    before = gdal.GetConfigOption("GDAL_DRIVER_PATH")
    for folder in places.driver_folders():
        gdal.SetConfigOption("GDAL_DRIVER_PATH", folder)
        gdal.PushErrorHandler("CPLQuietErrorHandler")
        try:
            gdal.AllRegister()
        finally:
            gdal.PopErrorHandler()
            gdal.SetConfigOption("GDAL_DRIVER_PATH", before)
        if gdal.GetDriverByName(NAME):
            return True
    return False


def triangles(folder):
    """The layer of triangles of a terrain folder, as QGIS names it."""
    return f"{folder}|layername=triangles"
