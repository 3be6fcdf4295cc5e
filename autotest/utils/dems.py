# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The DEMs of the tests by name: each a function path -> path of the file, None where there is none."""

import numpy as np
from make_dem import make_dem
from osgeo import gdal

import harness

gdal.UseExceptions()


def _real(file, window=None, size=None):
    """A DEM of QMESH_TEST_DATA; unless all is run, `window` (column, row, columns, rows) is cut out and
    averaged to `size` (columns, rows)."""

    def get(path):
        source = harness.DATA / file
        if not source.exists():
            return None
        if (window is None and size is None) or harness.FULL:
            return source
        cut = {"srcWin": list(window)} if window else {}
        scaled = {"width": size[0], "height": size[1], "resampleAlg": "average"} if size else {}
        gdal.Translate(str(path), str(source), **cut, **scaled)
        return path

    return get


def _synthetic(kind, **options):
    return lambda path: make_dem(kind, path, **options)


REAL = {
    "global_etopo": _real("global_etopo_20min.tif"),
    "bigtujunga": _real("bigtujunga_srtm_30m_utm11n.tif"),
    # across the border between land, sea and the void half
    "capeflattery": _real("capeflattery_srtm1_n48w125.tif", (1500, 1500, 700, 700)),
    # with voids in the mountains
    "pyrenees": _real("pyrenees_srtm3_n41n42e001.tif", (0, 0, 1201, 1000)),
    "montereybay": _real("montereybay_noaa_topobathy.tif"),
    "celticsea": _real("celticsea_etopo1.tif"),
    "netherlands": _real("netherlands_gtopo30.tif"),
    "slovenia": _real("slovenia_lidar_1m.tif"),
    "sthelens": _real("sthelens_usgs_30m_nad27.tif"),
}

SYNTHETIC = {
    "global": _synthetic("global"),
    "void": _synthetic("void", dtype="Int16"),
    "bathymetry": _synthetic("bathymetry"),
    "antimeridian": _synthetic("antimeridian"),
    "antimeridian_utm": _synthetic(
        "antimeridian", srs="EPSG:32601", lonlat_box=(179.0, 10.0, 181.0, 12.0), size=(250, 250)
    ),
    "north_pole": _synthetic(
        "global", srs="EPSG:3413", box=(-2e6, -2e6, 2e6, 2e6), size=(200, 200)
    ),
    "south_pole": _synthetic(
        "global", srs="EPSG:3031", box=(-1e6, -1.5e6, 2e6, 1.5e6), size=(150, 150)
    ),
    "small": _synthetic("terrain", lonlat_box=(10.0, 46.0, 10.05, 46.05), size=(60, 60)),
    "rotated": _synthetic("terrain", srs="EPSG:32632", rotate=25.0, size=(220, 180)),
}

SHIPPED = {"jacksboro": lambda path: harness.SHIPPED}

DEMS = {**SHIPPED, **SYNTHETIC, **REAL}

# For tests of every method: a few tiles of 64 cells at the native zoom.
SMALL = {
    "small_bigtujunga": _real("bigtujunga_srtm_30m_utm11n.tif", (700, 150, 70, 80)),
    "small_montereybay": _real("montereybay_noaa_topobathy.tif", (250, 150, 95, 95)),
    "small_celticsea": _real("celticsea_etopo1.tif", (120, 260, 85, 85)),
    "small_slovenia": _real("slovenia_lidar_1m.tif", (300, 300, 110, 140), (55, 70)),
    "small_global": _real("global_etopo_20min.tif", size=(256, 128)),
}


def write(path, values, transform=(10.0, 0.001, 0.0, 47.0, 0.0, -0.001), srs="EPSG:4326", **options):
    """A one-band GeoTIFF of an array. Options: nodata, unit, scale, offset, driver, dtype."""
    values = np.atleast_2d(values)
    kinds = {"uint8": gdal.GDT_Byte, "int16": gdal.GDT_Int16, "float32": gdal.GDT_Float32,
             "float64": gdal.GDT_Float64, "complex64": gdal.GDT_CFloat32}
    driver = gdal.GetDriverByName(options.get("driver", "GTiff"))
    rows, columns = values.shape
    data = driver.Create(str(path), columns, rows, 1, kinds[str(values.dtype)])
    if transform is not None:
        data.SetGeoTransform(transform)
    if srs is not None:
        reference = gdal.osr.SpatialReference()
        reference.SetFromUserInput(srs)
        data.SetProjection(reference.ExportToWkt())
    band = data.GetRasterBand(1)
    if "nodata" in options:
        band.SetNoDataValue(options["nodata"])
    if "unit" in options:
        band.SetUnitType(options["unit"])
    if "scale" in options:
        band.SetScale(options["scale"])
    if "offset" in options:
        band.SetOffset(options["offset"])
    band.WriteArray(values)
    return path


def hills(rows, columns, low=100.0, high=900.0, seed=11):
    """Smooth random heights, float32, a pure function of the arguments."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[0:rows, 0:columns] / max(rows, columns, 2)
    total = np.zeros((rows, columns))
    for k in range(1, 7):
        a, b, phase = random.normal(size=3)
        total += np.sin(2 * np.pi * 1.6**k * (a * x + b * y) + 6 * phase) / 1.7**k
    total = (total - total.min()) / max(np.ptp(total), 1e-9)
    return (low + (high - low) * total).astype(np.float32)
