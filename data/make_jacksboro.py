#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Writes jacksboro_srtm3.tif from the sample data of Debian's package python-matplotlib-data.

    make_jacksboro.py jacksboro_fault_dem.npz jacksboro_srtm3.tif

Needs numpy and GDAL's Python bindings. data/README.md says where the heights come from and why the
north edge is the file's `ymax`.
"""
import sys

import numpy as np
from osgeo import gdal, osr

CELLS_PER_DEGREE = 1200  # 3 arc seconds


def outer_edge(degrees):
    """The nearest half cell: SRTM posts lie on whole multiples of 3 arc seconds."""
    return round(degrees * CELLS_PER_DEGREE * 2) / 2 / CELLS_PER_DEGREE


def main(source, target):
    gdal.UseExceptions()
    with np.load(source) as sample:
        heights = sample["elevation"]
        west, north = outer_edge(float(sample["xmin"])), outer_edge(float(sample["ymax"]))
    rows, columns = heights.shape
    cell = 1 / CELLS_PER_DEGREE
    options = ["COMPRESS=DEFLATE", "PREDICTOR=2", "ZLEVEL=9", "BLOCKYSIZE=%d" % rows]
    tiff = gdal.GetDriverByName("GTiff").Create(target, columns, rows, 1, gdal.GDT_Int16, options)
    wgs84 = osr.SpatialReference()
    wgs84.ImportFromEPSG(4326)
    tiff.SetProjection(wgs84.ExportToWkt())
    tiff.SetMetadataItem("AREA_OR_POINT", "Point")
    tiff.SetGeoTransform((west, cell, 0, north, 0, -cell))
    band = tiff.GetRasterBand(1)
    band.SetUnitType("m")
    band.WriteArray(heights)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
