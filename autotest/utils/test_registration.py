# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Heights come back at their exact positions: steep analytic surfaces in several systems. Half a cell
of misplacement would change every height by many times the tolerance."""

import numpy as np
import pytest
from make_dem import make_dem
from osgeo import gdal, osr

import harness
from oracle import earth
from oracle.tileset import TileSet

CELLS = 200
PLACES = {  # srs: box in it; 1000 m of height over CELLS cells, so 5 m a cell
    "EPSG:4326": (10.0, 46.0, 10.02, 46.02),
    "EPSG:32632": (500000.0, 5100000.0, 502000.0, 5102000.0),
    "EPSG:3413": (400000.0, -1800000.0, 403000.0, -1797000.0),
    "EPSG:3857": (1113000.0, 5780000.0, 1116000.0, 5783000.0),
}
SLOPES = {"ramp": (1000.0, 0.0), "plane": (1000.0, 500.0)}
TOLERANCE = 0.12  # metres: a 1/256 cell is 0.02, quantized heights and positions take the rest


def reference(srs):
    crs = osr.SpatialReference()
    crs.SetFromUserInput(srs)
    crs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return crs


def vertices(tiles):
    """(lon, lat, height, normals) of all vertices of the finest level."""
    parts = []
    for name in tiles.levels()[max(tiles.levels())]:
        tile = tiles.tile(*name)
        lon, lat = tile.positions(tiles.scheme.box(*name))
        parts.append(np.column_stack([lon, lat, tile.heights(), earth.oct_decode(tile.oct_normals())]))
    whole = np.concatenate(parts)
    return whole[:, 0], whole[:, 1], whole[:, 2], whole[:, 3:]


def expected(kind, srs, box, lon, lat):
    """(height, inside) of the analytic surface; inside: a cell or more away from the rim."""
    west, south, east, north = box
    x, y = lon, lat
    if srs != "EPSG:4326":
        forward = osr.CoordinateTransformation(reference("EPSG:4326"), reference(srs))
        points = np.array(forward.TransformPoints(np.column_stack([lon, lat]).tolist()))
        x, y = points[:, 0], points[:, 1]
    fx, fy = (x - west) / (east - west), (y - south) / (north - south)
    rim = 1.5 / CELLS
    inside = (fx > rim) & (fx < 1 - rim) & (fy > rim) & (fy < 1 - rim)
    slope = SLOPES[kind]
    return slope[0] * fx + slope[1] * fy, inside


@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
@pytest.mark.parametrize("point", [False, True], ids=["area", "point"])
@pytest.mark.parametrize("srs", PLACES)
@pytest.mark.parametrize("kind", SLOPES)
def test_heights_lie_where_they_belong(tmp_path, kind, srs, point, profile):
    box = PLACES[srs]
    make_dem(kind, tmp_path / "a.tif", srs=srs, box=box, size=(CELLS, CELLS), point=point,
             dtype="Float64")
    assert gdal.Open(str(tmp_path / "a.tif")).GetMetadataItem("AREA_OR_POINT") == (
        "Point" if point else "Area")
    # The error sets the step of border heights: 1/16 m.
    harness.gdal2qmesh("-q", "-p", profile, "--method", "delaunay", "--tilesize", "64",
                       "--max-error", "0.2", tmp_path / "a.tif", tmp_path / "a").succeeded()
    lon, lat, height, _ = vertices(TileSet(tmp_path / "a"))
    want, inside = expected(kind, srs, box, lon, lat)
    assert inside.sum() > 10000
    error = np.abs(height - want)[inside].max()
    assert error < TOLERANCE
    half_a_cell = 0.5 * SLOPES[kind][0] / CELLS
    assert half_a_cell > 10 * TOLERANCE


def test_the_simplified_mesh_is_registered_too(tmp_path):
    """A ramp needs few triangles, but they lie right."""
    box = PLACES["EPSG:32632"]
    make_dem("plane", tmp_path / "a.tif", srs="EPSG:32632", box=box, size=(CELLS, CELLS))
    harness.gdal2qmesh("-q", "--max-error", "0.1", tmp_path / "a.tif", tmp_path / "a").succeeded()
    lon, lat, height, _ = vertices(TileSet(tmp_path / "a"))
    want, inside = expected("plane", "EPSG:32632", box, lon, lat)
    assert inside.sum() > 8
    assert np.abs(height - want)[inside].max() < 0.1 + TOLERANCE


def test_normals_are_those_of_the_surface(tmp_path):
    """On a plane of known slope, in the earth-fixed frame: within what two bytes can say."""
    box = PLACES["EPSG:4326"]
    make_dem("plane", tmp_path / "a.tif", box=box, size=(CELLS, CELLS))
    harness.gdal2qmesh("-q", "--method", "delaunay", "--tilesize", "64", tmp_path / "a.tif",
                       tmp_path / "a").succeeded()
    lon, lat, _, normals = vertices(TileSet(tmp_path / "a"))
    _, inside = expected("plane", "EPSG:4326", box, lon, lat)
    east, north = earth.metres_per_degree(lat)
    want = earth.gradient_normal(lon, lat, 1000 / 0.02 / east, 500 / 0.02 / north)
    angle = np.degrees(np.arccos(np.clip((normals * want).sum(axis=1), -1, 1)))
    assert angle[inside].max() < 1.2
    flat = np.degrees(np.arccos((earth.surface_normal(lon, lat) * want).sum(axis=1)))
    assert flat.min() > 30, "the slope is too gentle to prove anything"
