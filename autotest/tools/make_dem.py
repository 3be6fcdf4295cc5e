#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Synthetic DEMs for the tests: every file is a pure function of the arguments.

    make_dem.py KIND OUTPUT.tif [options]          (make_dem.py --help lists them)

Kinds, and the box in longitude and latitude each has by default:

  terrain       fractal hills, 0.5 x 0.5 degrees in the Alps
  global        the whole Earth, land and sea floor, smooth across the poles and the antimeridian
  void          terrain whose northern half is void, with speckle and round holes in the rest
  bathymetry    sea floor down to about -4000 m with some land; --positive-down turns the sign
  antimeridian  terrain in 170..190 E, across the antimeridian (continuous there)
  ramp          0 m on the box's western edge to 1000 m on its eastern, linear in the CRS's x
  plane         1000 m * fx + 500 m * fy, fx and fy from 0 to 1 across the box in the CRS's x and y

The surface of every other kind is a function of the place on Earth alone (`surface`), so the same kind in
two CRSs is the same terrain. Also usable as a module: `make_dem(kind, path, srs=..., size=...)`.
"""
import argparse

import numpy as np
from osgeo import gdal, osr

gdal.UseExceptions()
osr.UseExceptions()

LONLAT_BOXES = {  # west, south, east, north in degrees; east may exceed 180
    "terrain": (10.0, 46.0, 10.5, 46.5),
    "global": (-180.0, -90.0, 180.0, 90.0),
    "void": (10.0, 46.0, 10.5, 46.5),
    "bathymetry": (-8.0, 47.0, -4.0, 51.0),
    "antimeridian": (170.0, -25.0, 190.0, -5.0),
    "ramp": (10.0, 46.0, 10.5, 46.5),
    "plane": (10.0, 46.0, 10.5, 46.5),
}
SIZES = {"global": (720, 360), "antimeridian": (400, 400)}  # columns, rows; else 300 x 300
DEFAULT_SIZE = (300, 300)
ROWS_AT_ONCE = 256


def fractal(lon, lat, wavelength, octaves, seed):
    """Sum of plane waves through the unit sphere, about -1..1: no seam at 180 degrees, no pole.

    wavelength: of the first octave, in degrees of a great circle; each further octave halves it and
    carries 0.55 of the height.
    """
    lam, phi = np.radians(lon), np.radians(lat)
    place = np.stack([np.cos(phi) * np.cos(lam), np.cos(phi) * np.sin(lam), np.sin(phi)])
    random = np.random.RandomState(seed)
    total = np.zeros(np.shape(lon))
    weight = 0.0
    for octave in range(octaves):
        for _ in range(4):
            direction = random.normal(size=3)
            direction *= 2**octave * 360 / wavelength / np.linalg.norm(direction)
            phase = random.uniform(0, 2 * np.pi)
            total += 0.55**octave * np.sin(np.tensordot(direction, place, 1) + phase)
        weight += 0.55**octave
    return total / (2 * weight)


def surface(kind, lon, lat, seed=1):
    """Heights in metres at longitudes and latitudes in degrees, voids not yet cut."""
    if kind == "global":
        return 4500 * fractal(lon, lat, 120, 6, seed) - 1500
    if kind == "bathymetry":
        return 3600 * fractal(lon, lat, 5, 7, seed) - 1300
    if kind == "antimeridian":
        return 1200 * fractal(lon, lat, 12, 7, seed) + 600
    return 800 * fractal(lon, lat, 0.4, 7, seed) + 900


def void_mask(fx, fy, columns, first_row, seed):
    """Where `void` has no data: fx, fy in 0..1 from the south-western corner of the box."""
    mask = fy > 0.5
    random = np.random.RandomState(seed + 7)
    for _ in range(12):
        x, y, radius = random.uniform(0, 1), random.uniform(0, 0.5), random.uniform(0.005, 0.04)
        mask |= (fx - x) ** 2 + (fy - y) ** 2 < radius**2
    for row in range(mask.shape[0]):
        speckle = np.random.RandomState([seed, first_row + row]).random_sample(columns)
        mask[row] |= speckle < 0.01
    return mask


def spatial_reference(definition):
    srs = osr.SpatialReference()
    srs.SetFromUserInput(definition)
    srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return srs


def box_in_crs(lonlat_box, srs):
    """The box around the outline of a longitude/latitude box in another CRS."""
    west, south, east, north = lonlat_box
    if srs.IsGeographic():
        return lonlat_box
    along = np.linspace(0, 1, 33)
    lon = west + (east - west) * along
    lat = south + (north - south) * along
    outline = [(x, y) for x in lon for y in (south, north)]
    outline += [(x, y) for y in lat for x in (west, east)]
    to_crs = osr.CoordinateTransformation(spatial_reference("EPSG:4326"), srs)
    points = np.array(to_crs.TransformPoints(outline))
    return (*points[:, :2].min(0), *points[:, :2].max(0))


def geotransform(box, size, point, rotate):
    """GDAL's six numbers; with `point` the outermost pixel *centres* lie on the box."""
    west, south, east, north = box
    columns, rows = size
    dx = (east - west) / (columns - 1 if point else columns)
    dy = (north - south) / (rows - 1 if point else rows)
    half = 0.5 if point else 0.0
    turn = np.radians(rotate)
    cos, sin = np.cos(turn), np.sin(turn)
    centre_x, centre_y = (west + east) / 2, (south + north) / 2
    corner_x, corner_y = west - half * dx - centre_x, north + half * dy - centre_y
    if rotate == 0:
        return (west - half * dx, dx, 0.0, north + half * dy, 0.0, -dy)
    return (centre_x + cos * corner_x - sin * corner_y, cos * dx, sin * dy,
            centre_y + sin * corner_x + cos * corner_y, sin * dx, -cos * dy)


def lonlat_of(x, y, srs):
    """Longitude and latitude of CRS coordinates (arrays of one shape)."""
    if srs.IsGeographic():
        return x, y
    to_lonlat = osr.CoordinateTransformation(srs, spatial_reference("EPSG:4326"))
    points = np.array(to_lonlat.TransformPoints(np.stack([x.ravel(), y.ravel()], 1)))
    return points[:, 0].reshape(x.shape), points[:, 1].reshape(x.shape)


def rows_of_heights(kind, first_row, count, columns, frame):
    """Heights of some rows with NaN in voids; frame: dict of gt, box, srs, seed."""
    gt, (west, south, east, north) = frame["gt"], frame["box"]
    column, row = np.meshgrid(np.arange(columns) + 0.5, np.arange(first_row, first_row + count) + 0.5)
    x = gt[0] + gt[1] * column + gt[2] * row
    y = gt[3] + gt[4] * column + gt[5] * row
    fx, fy = (x - west) / (east - west), (y - south) / (north - south)
    if kind == "ramp":
        return 1000 * fx
    if kind == "plane":
        return 1000 * fx + 500 * fy
    heights = surface(kind, *lonlat_of(x, y, frame["srs"]), seed=frame["seed"])
    if kind == "void":
        heights[void_mask(fx, fy, columns, first_row, frame["seed"])] = np.nan
    return heights


def default_nodata(dtype):
    return {"Byte": 0, "UInt16": 65535, "UInt32": 4294967295, "Int16": -32768, "Int32": -32768}.get(
        dtype, -9999)


def make_dem(kind, path, srs="EPSG:4326", size=None, dtype="Float32", box=None, lonlat_box=None,
             point=False, rotate=0.0, nodata=None, positive_down=False, seed=1, options=()):
    """Writes one GeoTIFF and returns its path.

    box: west, south, east, north in the CRS (ramp and plane refer to it); default: around
    lonlat_box, itself by default LONLAT_BOXES[kind]. size: columns, rows. point: pixel-is-point.
    rotate: degrees counter-clockwise about the box's centre. nodata: a number or "nan".
    """
    crs = spatial_reference(srs)
    box = tuple(box) if box else box_in_crs(lonlat_box or LONLAT_BOXES[kind], crs)
    columns, rows = size or SIZES.get(kind, DEFAULT_SIZE)
    frame = {"gt": geotransform(box, (columns, rows), point, rotate), "box": box, "srs": crs,
             "seed": seed}
    whole = gdal.GetDataTypeByName(dtype) not in (gdal.GDT_Float32, gdal.GDT_Float64)
    nodata = default_nodata(dtype) if nodata is None else float(nodata)

    creation = ["COMPRESS=DEFLATE", *options]
    data = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, 1,
                                                gdal.GetDataTypeByName(dtype), creation)
    data.SetProjection(crs.ExportToWkt())
    data.SetMetadataItem("AREA_OR_POINT", "Point" if point else "Area")
    data.SetGeoTransform(frame["gt"])
    band = data.GetRasterBand(1)
    if kind == "void":
        band.SetNoDataValue(nodata)
    for first in range(0, rows, ROWS_AT_ONCE):
        count = min(ROWS_AT_ONCE, rows - first)
        heights = rows_of_heights(kind, first, count, columns, frame)
        heights = -heights if positive_down else heights
        heights = np.round(heights) if whole else heights
        band.WriteArray(np.where(np.isnan(heights), nodata, heights), 0, first)
    return path


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=sorted(LONLAT_BOXES))
    parser.add_argument("path", metavar="OUTPUT.tif")
    parser.add_argument("--srs", default="EPSG:4326")
    parser.add_argument("--size", nargs=2, type=int, metavar=("COLUMNS", "ROWS"))
    parser.add_argument("--dtype", default="Float32", help="GDAL type name (default %(default)s)")
    edges = ("WEST", "SOUTH", "EAST", "NORTH")
    parser.add_argument("--box", nargs=4, type=float, metavar=edges, help="in the CRS")
    parser.add_argument("--lonlat-box", nargs=4, type=float, metavar=edges, help="in degrees")
    parser.add_argument("--point", action="store_true", help="pixel-is-point")
    parser.add_argument("--rotate", type=float, default=0.0, metavar="DEGREES")
    parser.add_argument("--nodata", help="value of voids, or nan")
    parser.add_argument("--positive-down", action="store_true", help="depths positive")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--co", dest="options", action="append", default=[], metavar="NAME=VALUE")
    make_dem(**vars(parser.parse_args()))


if __name__ == "__main__":
    main()
