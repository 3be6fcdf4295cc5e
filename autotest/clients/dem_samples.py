# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Places where a client must find a DEM's height, and how well."""

import numpy as np
from osgeo import gdal, osr

gdal.UseExceptions()
osr.UseExceptions()

CELLS = 256  # per tile edge
ROOT_DEGREES = 180.0  # a geodetic root tile
CLIENT_SLACK = 0.05  # metres: CesiumJS interpolates in decoded 15-bit heights


def max_error(zoom, last_zoom):
    """--screen-error's default, 0.5 px: a quarter of what CesiumJS takes a level for; half at the last."""
    return 0.25 * 77067.34 / 2**zoom * (0.5 if zoom == last_zoom else 1)


class Dem:
    """Bilinear heights of a DEM by longitude and latitude, and how they vary around a place."""

    def __init__(self, path):
        data = gdal.Open(str(path))
        self.heights = data.ReadAsArray().astype(float)
        nodata = data.GetRasterBand(1).GetNoDataValue()
        if nodata is not None:
            self.heights[self.heights == nodata] = np.nan
        self.gt = data.GetGeoTransform()
        self.inverse = gdal.InvGeoTransform(self.gt)
        srs = data.GetSpatialRef()
        srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        lonlat = osr.SpatialReference()
        lonlat.ImportFromEPSG(4326)
        lonlat.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        self.plain = bool(srs.IsGeographic())
        if not self.plain:
            self.to_lonlat = osr.CoordinateTransformation(srs, lonlat)
            self.from_lonlat = osr.CoordinateTransformation(lonlat, srs)

    def lonlat_of_pixel(self, column, row):
        x, y = gdal.ApplyGeoTransform(self.gt, column, row)
        return (x, y) if self.plain else self.to_lonlat.TransformPoint(x, y)[:2]

    def pixel_of_lonlat(self, lon, lat):
        x, y = (lon, lat) if self.plain else self.from_lonlat.TransformPoint(lon, lat)[:2]
        return gdal.ApplyGeoTransform(self.inverse, x, y)

    def height(self, column, row):
        """Bilinear between pixel centres; NaN beside voids and within a cell of the rim."""
        rows, columns = self.heights.shape
        if not (1.5 < column < columns - 1.5 and 1.5 < row < rows - 1.5):
            return np.nan
        x, y = column - 0.5, row - 0.5
        i, j = int(x), int(y)
        a, b = x - i, y - j
        square = self.heights[j:j + 2, i:i + 2]
        return float((1 - b) * ((1 - a) * square[0, 0] + a * square[0, 1])
                     + b * ((1 - a) * square[1, 0] + a * square[1, 1]))

    def relief(self, column, row):
        """Range of heights within two cells of a place: how much moving by less can matter."""
        i, j = int(column), int(row)
        around = self.heights[max(j - 2, 0):j + 3, max(i - 2, 0):i + 3]
        return float(np.ptp(around))


def near_node(lon, lat, zoom):
    """The nearest node of a zoom's lattice: there the mesh promises its error."""
    step = ROOT_DEGREES / CELLS / 2**zoom
    return round((lon + 180) / step) * step - 180, round((lat + 90) / step) * step - 90


def dem_samples(path, zoom, count=200, seed=5):
    """`count` places as {lon, lat, height, tolerance} for a default geodetic set with this last zoom.

    Half lie on nodes: the level's max error holds, plus what a 1/256 of a pixel in position makes.
    Half lie on random places: between nodes the mesh and the DEM interpolate differently, by a share of
    the relief nearby.
    """
    dem = Dem(path)
    rows, columns = dem.heights.shape
    random = np.random.RandomState(seed)
    error = max_error(zoom, zoom)
    samples = []
    for attempt in range(100 * count):
        if len(samples) == count:
            return samples
        lon, lat = dem.lonlat_of_pixel(random.uniform(2, columns - 2), random.uniform(2, rows - 2))
        on_node = attempt % 2 == 0
        if on_node:
            lon, lat = near_node(lon, lat, zoom)
        column, row = dem.pixel_of_lonlat(lon, lat)
        height, relief = dem.height(column, row), dem.relief(column, row)
        if not np.isfinite(height + relief) or abs(lat) > 89:
            continue
        tolerance = error + CLIENT_SLACK + relief * (2 / 256 if on_node else 0.5)
        samples.append({"lon": (lon + 180) % 360 - 180, "lat": lat, "height": height,
                        "tolerance": tolerance})
    raise ValueError(f"{path} has too few valid places")
