# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What the tests ask GDAL about an open set."""

import math
from contextlib import contextmanager

import numpy as np
from osgeo import gdal

from oracle.scheme import EARTH_RADIUS

NODATA = -32768.0


def raster(name, **options):
    """Opened as raster with open options."""
    return gdal.OpenEx(str(name), gdal.OF_RASTER | gdal.OF_VERBOSE_ERROR, open_options=_list(options))


def vector(name, **options):
    return gdal.OpenEx(str(name), gdal.OF_VECTOR | gdal.OF_VERBOSE_ERROR, open_options=_list(options))


def _list(options):
    return [f"{key}={value}" for key, value in options.items()]


def centres(band, transform, degrees=True):
    """(lon, lat) arrays of the centres of a band's pixels; the band may be an overview of the dataset
    with that geotransform and as many columns as `transform` tells."""
    x0, dx, _, y0, _, dy = transform
    x = x0 + dx * (np.arange(band.XSize) + 0.5)
    y = y0 + dy * (np.arange(band.YSize) + 0.5)
    if degrees:
        return x, y
    return np.degrees(x / EARTH_RADIUS), np.degrees(np.arctan(np.sinh(y / EARTH_RADIUS)))


def overview_transform(dataset, overview):
    x0, dx, _, y0, _, dy = dataset.GetGeoTransform()
    return (x0, dx * dataset.RasterXSize / overview.XSize, 0, y0, 0, dy * dataset.RasterYSize / overview.YSize)


def mercator_half():
    return math.pi * EARTH_RADIUS


@contextmanager
def heard():
    """Collects (class, text) of what GDAL reports."""
    said = []
    gdal.PushErrorHandler(lambda kind, number, text: said.append((kind, text)))
    try:
        yield said
    finally:
        gdal.PopErrorHandler()
