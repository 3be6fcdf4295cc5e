# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Terrain as layers of QGIS through the driver, which the plugin registers, and the algorithm Extract triangles."""

import os
import subprocess


import numpy as np
import pytest
from conftest import BUILD, DEM
from osgeo import gdal, ogr

from oracle.tileset import TileSet

ZOOM = 8


@pytest.fixture(scope="module")
def terrain(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sets") / "terrain"
    subprocess.run([BUILD / "bin" / "gdal2qmesh", "-q", "-z", f"0-{ZOOM}", "--tilesize", "64", DEM, folder], check=True)
    return folder


@pytest.fixture(scope="module")
def tiles(terrain):
    """Tile name -> decoded tile of the last zoom, by a decoder that shares no code with the driver."""
    tile_set = TileSet(terrain)
    return {name: (tile_set.tile(*name), tile_set.scheme.box(*name)) for name in tile_set.levels()[ZOOM]}


def geometries_of(path):
    source = ogr.Open(str(path))
    names = []
    for feature in source.GetLayer(0):
        shape = feature.GetGeometryRef()
        names.append(shape.GetGeometryName() + " Z" * shape.Is3D())
    return names


def corners_of(path):
    """Sorted corners (lon, lat, height) of all polygons, rounded to what a format may lose."""
    source = ogr.Open(str(path))
    found = []
    for feature in source.GetLayer(0):
        ring = feature.GetGeometryRef().GetGeometryRef(0)
        found.append(sorted(tuple(round(c, 6) for c in ring.GetPoint(k)) for k in range(3)))
    return sorted(found)


def expected_corners(tiles, box=None):
    found = []
    for tile, tile_box in tiles.values():
        lon, lat = tile.positions(tile_box)
        height = tile.heights()
        for triangle in tile.triangles:
            if box is None or meets(lon[triangle], lat[triangle], box):
                found.append(sorted(tuple(round(float(v), 6) for v in (lon[k], lat[k], height[k])) for k in triangle))
    return sorted(found)


def meets(lon, lat, box):
    triangle = ogr.CreateGeometryFromWkt(
        "POLYGON((" + ",".join(f"{x!r} {y!r}" for x, y in zip([*map(float, lon), float(lon[0])], [*map(float, lat), float(lat[0])])) + "))"
    )
    west, south, east, north = box
    area = ogr.CreateGeometryFromWkt(
        f"POLYGON(({west} {south},{east} {south},{east} {north},{west} {north},{west} {south}))"
    )
    return triangle.Intersects(area)


def close(found, expected):
    return len(found) == len(expected) > 0 and np.allclose(np.array(found), np.array(expected), rtol=0, atol=2e-6)


def test_the_plugin_registers_the_driver(qgis):
    assert gdal.GetDriverByName("QMESH") is not None
    assert gdal.GetConfigOption("GDAL_DRIVER_PATH") is None


def test_results_are_layers(qgis, tmp_path):
    """What Generate gives opens in QGIS, and is opened in the project where that is wanted."""
    import processing
    from qgis.core import QgsProcessingContext, QgsProcessingUtils, QgsProject, QgsRasterLayer, QgsVectorLayer, QgsWkbTypes

    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    results = processing.run(
        "qmesh:generate",
        {"INPUT": str(DEM), "OUTPUT": str(tmp_path / "a"), "TILESIZE": "64", "MAX_ZOOM": ZOOM, "LOAD_TRIANGLES": True},
        context=context,
    )
    raster = QgsRasterLayer(results["RASTER"], "terrain")
    assert raster.isValid() and raster.crs().authid() == "EPSG:4326" and raster.width() % 64 == 0
    high = raster.dataProvider().bandStatistics(1).maximumValue
    assert 900 < high < 1100
    triangles = QgsVectorLayer(results["TRIANGLES"], "triangles", "ogr")
    assert triangles.isValid() and QgsWkbTypes.hasZ(triangles.wkbType())
    assert triangles.geometryType() == QgsWkbTypes.PolygonGeometry
    to_load = context.layersToLoadOnCompletion()
    assert {details.outputName for details in to_load.values()} == {"RASTER", "TRIANGLES"}
    for path, details in to_load.items():
        layer = QgsProcessingUtils.mapLayerFromString(path, context, True, details.layerTypeHint)
        assert layer is not None and layer.isValid(), path


def test_without_the_driver_the_terrain_is_made_all_the_same(run_process, tmp_path):
    """The command beside the plugin, and no driver anywhere; the message says what to do."""
    (tmp_path / "bin").mkdir()
    os.symlink("/bin/true", tmp_path / "bin" / "qmeshinfo")
    # A copy, so that its folder leads to no driver.
    subprocess.run(["cp", BUILD / "bin" / "gdal2qmesh", tmp_path / "bin"], check=True)
    environment = {"PATH": f"{tmp_path / 'bin'}:/usr/bin:/bin"}
    process = run_process("qmesh:generate", environment, INPUT=DEM, OUTPUT=tmp_path / "a", MAX_ZOOM=3)
    results = process.succeeded()
    assert (tmp_path / "a" / "layer.json").exists() and "RASTER" not in results
    assert "GDAL's QMESH driver is not there" in process.text
    process = run_process("qmesh:triangles", environment, INPUT=tmp_path / "a", OUTPUT=tmp_path / "t.gpkg")
    process.failed("GDAL's QMESH driver is not there", "Settings > Options")


def test_triangles_by_qgis_process(run_process, terrain, tiles, tmp_path):
    results = run_process("qmesh:triangles", INPUT=terrain, OUTPUT=tmp_path / "t.gpkg").succeeded()
    assert results["OUTPUT"] == str(tmp_path / "t.gpkg")
    assert close(corners_of(tmp_path / "t.gpkg"), expected_corners(tiles))


@pytest.mark.parametrize("extension", ["geojson", "fgb", "gpkg"])
def test_triangles_of_an_extent_in_any_format(qgis, feedback, terrain, tiles, tmp_path, extension):
    import processing

    box = (-84.31, 36.21, -84.27, 36.24)
    output = str(tmp_path / f"t.{extension}")
    extent = f"{box[0]},{box[2]},{box[1]},{box[3]} [EPSG:4326]"
    processing.run("qmesh:triangles", {"INPUT": str(terrain), "EXTENT": extent, "OUTPUT": output}, feedback=feedback)
    found, expected = corners_of(output), expected_corners(tiles, box)
    assert close(found, expected) and len(found) < len(expected_corners(tiles))


def test_an_extent_in_another_crs(qgis, terrain, tiles, tmp_path):
    import processing
    from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsProject, QgsRectangle

    box = QgsRectangle(-84.31, 36.21, -84.27, 36.24)
    to_metres = QgsCoordinateTransform(
        QgsCoordinateReferenceSystem("EPSG:4326"), QgsCoordinateReferenceSystem("EPSG:3857"), QgsProject.instance()
    )
    metres = to_metres.transformBoundingBox(box)
    extent = f"{metres.xMinimum()},{metres.xMaximum()},{metres.yMinimum()},{metres.yMaximum()} [EPSG:3857]"
    output = str(tmp_path / "t.gpkg")
    processing.run("qmesh:triangles", {"INPUT": str(terrain), "EXTENT": extent, "OUTPUT": output})
    expected = expected_corners(tiles, (-84.31, 36.21, -84.27, 36.24))
    assert abs(len(corners_of(output)) - len(expected)) <= 0.1 * len(expected)


@pytest.mark.parametrize(
    "what, count, geometry",
    [
        ("multipolygons", lambda tiles: len(tiles), "MULTIPOLYGON Z"),
        ("tin", lambda tiles: len(tiles), "TIN Z"),
        ("tiles", lambda tiles: len(tiles), "POLYGON"),
        ("vertices", lambda tiles: sum(len(tile.u) for tile, _ in tiles.values()), "POINT Z"),
    ],
)
def test_what_else_is_extracted(qgis, terrain, tiles, tmp_path, what, count, geometry):
    import processing

    output = tmp_path / "t.gpkg"
    processing.run("qmesh:triangles", {"INPUT": str(terrain), "WHAT": what, "OUTPUT": str(output)})
    found = geometries_of(output)
    assert len(found) == count(tiles)
    assert set(found) == {geometry}


def test_another_zoom(qgis, terrain, tmp_path):
    import processing

    for zoom in (3, ZOOM):
        output = tmp_path / f"{zoom}.gpkg"
        processing.run("qmesh:triangles", {"INPUT": str(terrain), "WHAT": "tiles", "ZOOM": zoom, "OUTPUT": str(output)})
        assert len(geometries_of(output)) == len(TileSet(terrain).levels()[zoom])


def test_wrong_input(run_process, qgis, terrain, tmp_path):
    run_process("qmesh:triangles", INPUT=tmp_path / "none", OUTPUT=tmp_path / "t.gpkg").failed(str(tmp_path / "none"))
    run_process("qmesh:triangles", INPUT=terrain, ZOOM=23, OUTPUT=tmp_path / "t.gpkg").failed("ZOOM")
    run_process("qmesh:triangles", INPUT=terrain, OUTPUT="/proc/none/t.gpkg").failed("/proc/none")


def test_cancel_stops_the_extraction(qgis, feedback, terrain, tmp_path):
    import processing

    feedback.cancel()
    processing.run("qmesh:triangles", {"INPUT": str(terrain), "OUTPUT": str(tmp_path / "t.gpkg")}, feedback=feedback)
    assert not (tmp_path / "t.gpkg").exists()
