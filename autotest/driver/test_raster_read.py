# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""A set as a raster: names, geometry, overviews, open options, missing tiles, the utilities of GDAL."""

import json
import shutil
import subprocess
import sys
import threading
import zipfile

import numpy as np
import pytest
from osgeo import gdal

import dems
import promises
from formula_sets import Writer, plane, pyramid
from looking import NODATA, centres, heard, mercator_half, overview_transform, raster
from oracle.scheme import Scheme
from oracle.tileset import TileSet


def step_of(folder, z):
    """Metres that the quantization of a formula set may be off: half a 32767th of a tile's range."""
    return 5000 / 32767 + 1e-3 if z == 0 else 3000 / 32767 + 1e-3


def assert_plane(band, transform, tolerance, degrees=True):
    lon, lat = centres(band, transform, degrees)
    lon = np.where(lon > 180, lon - 360, lon)
    expected = plane(lon[None, :], lat[:, None])
    assert np.abs(band.ReadAsArray() - expected).max() < tolerance


# ---- Names ------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def small_set(tmp_path_factory):
    return pyramid(tmp_path_factory.mktemp("small") / "set", top=2).write_layer()


def test_every_name_of_a_set_opens_the_same(small_set, tmp_path, vsimem):
    expected = raster(small_set, ZOOM=2).ReadAsArray()
    names = [f"{small_set}/", f"{small_set}/layer.json", f"QMESH:{small_set}", f"QMESH:{small_set}/layer.json"]
    archive = tmp_path / "set.zip"
    with zipfile.ZipFile(archive, "w") as out:
        for file in sorted(small_set.rglob("*")):
            out.write(file, file.relative_to(small_set))
            if file.is_dir():
                gdal.Mkdir(f"{vsimem}/{file.relative_to(small_set)}", 0o755)
            else:
                gdal.FileFromMemBuffer(f"{vsimem}/{file.relative_to(small_set)}", file.read_bytes())
    names += [f"/vsizip/{archive}", f"QMESH:/vsizip/{archive}", vsimem, f"{vsimem}/layer.json"]
    for name in names:
        dataset = raster(name)
        assert dataset.GetDriver().ShortName == "QMESH", name
        assert np.array_equal(dataset.ReadAsArray(), expected), name


def test_a_tile_alone(small_set):
    whole = raster(small_set).ReadAsArray()
    dataset = raster(small_set / "2" / "5" / "3.terrain")
    assert (dataset.RasterXSize, dataset.RasterYSize) == (256, 256)
    assert dataset.GetRasterBand(1).GetOverviewCount() == 0
    assert np.array_equal(dataset.ReadAsArray(), whole[:256, 5 * 256 : 6 * 256])
    assert dataset.GetGeoTransform()[0::3] == (45.0, 90.0)


def test_a_tile_alone_without_layer_json(small_set, tmp_path):
    copy = tmp_path / "2" / "5" / "3.terrain"
    copy.parent.mkdir(parents=True)
    shutil.copy(small_set / "2" / "5" / "3.terrain", copy)
    assert np.array_equal(raster(copy).ReadAsArray(), raster(small_set / "2/5/3.terrain").ReadAsArray())
    nameless = tmp_path / "tile.terrain"
    shutil.copy(copy, nameless)
    with pytest.raises(RuntimeError, match="zoom/column/row"):
        raster(f"QMESH:{nameless}")


def test_opening_for_update_is_refused(small_set):
    with pytest.raises(RuntimeError, match="QMESH: .*read-only"):
        gdal.Open(str(small_set), gdal.GA_Update)


def test_opening_for_update_is_refused_in_silence_to_vector_programs(small_set):
    """They try it first: ogrinfo, QGIS."""
    with heard() as said:
        try:
            dataset = gdal.OpenEx(str(small_set), gdal.OF_VECTOR | gdal.OF_UPDATE)
        except RuntimeError:
            dataset = None
    assert dataset is None and not [text for _, text in said if "QMESH" in text]


# ---- Geometry ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
def test_levels_nest_without_a_shift(tmp_path, profile):
    """Base and every overview are the plane at the centres of their own cells."""
    top = 3
    folder = pyramid(tmp_path, profile, top).write_layer()
    dataset = raster(folder)
    degrees = profile == "geodetic"
    roots = 2 if degrees else 1
    assert (dataset.RasterXSize, dataset.RasterYSize) == (roots * 8 * 256, 8 * 256)
    half = 180.0 if degrees else mercator_half()
    assert dataset.GetGeoTransform()[0] == -half
    assert dataset.GetGeoTransform()[3] == (90.0 if degrees else pytest.approx(half, rel=1e-15))
    assert dataset.GetSpatialRef().GetAuthorityCode(None) == ("4326" if degrees else "3857")
    assert dataset.GetSpatialRef().GetDataAxisToSRSAxisMapping() == ([2, 1] if degrees else [1, 2])
    band = dataset.GetRasterBand(1)
    assert band.GetBlockSize() == [256, 256] and band.DataType == gdal.GDT_Float32
    assert band.GetUnitType() == "m" and band.GetNoDataValue() == NODATA
    assert_plane(band, dataset.GetGeoTransform(), step_of(folder, top), degrees)
    assert band.GetOverviewCount() == top
    for k in range(top):
        overview = band.GetOverview(k)
        assert overview.XSize * 2 ** (k + 1) == band.XSize
        assert_plane(overview, overview_transform(dataset, overview), step_of(folder, top - k - 1), degrees)


def test_overviews_of_an_odd_rectangle_nest_too(tmp_path):
    """The rectangle begins in the middle of coarser tiles; blocks of overviews then meet four of them."""
    writer = pyramid(tmp_path, top=4)
    writer.write_level(5, 37, 13, 41, 15)
    dataset = raster(writer.write_layer())
    assert (dataset.RasterXSize, dataset.RasterYSize) == (5 * 256, 3 * 256)
    assert dataset.GetGeoTransform()[0] == 37 * 5.625 - 180
    band = dataset.GetRasterBand(1)
    assert band.GetOverviewCount() == 5
    for k in range(5):
        overview = band.GetOverview(k)
        assert_plane(overview, overview_transform(dataset, overview), step_of(tmp_path, 4 - k))


@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
def test_nodes_lie_on_the_corners_of_the_cells(tmp_path, profile):
    folder = pyramid(tmp_path, profile, 2).write_layer()
    cells, nodes = raster(folder), raster(folder, REGISTRATION="NODE")
    assert nodes.RasterXSize == cells.RasterXSize + 1 and nodes.RasterYSize == cells.RasterYSize + 1
    a, b = cells.GetGeoTransform(), nodes.GetGeoTransform()
    assert b[0] == pytest.approx(a[0] - a[1] / 2, rel=1e-15)
    assert b[3] == pytest.approx(a[3] - a[5] / 2, rel=1e-15)
    band = nodes.GetRasterBand(1)
    assert band.GetOverviewCount() == 0
    assert nodes.GetMetadataItem("AREA_OR_POINT") == "Point"
    assert cells.GetMetadataItem("AREA_OR_POINT") == "Area"
    values = band.ReadAsArray()
    lon, lat = centres(band, b, profile == "geodetic")
    expected = plane(lon[None, :], lat[:, None])
    # The formula does not go round the globe, so at 180 degrees the tile of -180 may tell.
    assert np.abs(values - expected)[:, :-1].max() < 2 * step_of(folder, 0)
    assert np.isin(values[:, -1], values[:, 0]).all() or np.abs(values - expected)[:, -1].max() < 1


def test_a_set_across_the_antimeridian_is_one_small_raster(tmp_path):
    writer = pyramid(tmp_path, top=1)
    writer.write_level(4, 31, 7, 31, 8).write_level(4, 0, 7, 1, 8)
    dataset = raster(writer.write_layer())
    assert (dataset.RasterXSize, dataset.RasterYSize) == (3 * 256, 2 * 256)
    assert dataset.GetGeoTransform()[0] == 180 - 11.25
    assert_plane(dataset.GetRasterBand(1), dataset.GetGeoTransform(), step_of(tmp_path, 4))


def test_two_areas_that_do_not_meet_at_the_antimeridian_stay_where_they_are(tmp_path):
    writer = pyramid(tmp_path, top=1)
    writer.write_level(4, 2, 7, 2, 7).write_level(4, 30, 7, 30, 7)
    assert raster(writer.write_layer()).GetGeoTransform()[0] == 2 * 11.25 - 180


def test_a_set_made_of_a_real_dem(command_set):
    """Its own number of cells, and what it was made with."""
    folder = command_set("jacksboro", "-q", "--tilesize", 64)
    record = json.loads((folder / "layer.json").read_text())
    dataset = raster(folder)
    assert dataset.GetRasterBand(1).GetBlockSize() == [64, 64]
    metadata = dataset.GetMetadata()
    level = record["qmesh"]["levels"][-1]
    assert metadata["METHOD"] == "greedy" and metadata["EXTENSIONS"] == "octvertexnormals"
    assert float(metadata["MAX_ERROR"]) == level["maxError"]
    assert float(metadata["ERROR_REACHED"]) == level["errorReached"]
    assert metadata["VERSION"] == record["version"] and metadata["NAME"] == record["name"]
    assert metadata["ZOOM"] == metadata["MAXZOOM"] == str(record["maxzoom"])
    assert int(metadata["TILES"]) == len(list((folder / metadata["ZOOM"]).rglob("*.terrain")))
    assert dataset.GetFileList() == [str(folder / "layer.json")]


# ---- Every DEM, every node --------------------------------------------------------------------------



def round_trip_faults(folder, nodes, zooms):
    """P2 through the driver: every node of every tile of these zooms."""
    tiles = TileSet(folder)
    limits, levels, cells = promises.level_errors(tiles), tiles.levels(), nodes.cells
    half = (180.0, 90.0) if tiles.scheme.profile == "geodetic" else (mercator_half(),) * 2
    faults = []
    for z in zooms:
        dataset = raster(folder, ZOOM=z, REGISTRATION="NODE")
        west, res, _, north = dataset.GetGeoTransform()[:4]
        column0, row0 = round((west + res / 2 + half[0]) / res), round((half[1] - north + res / 2) / res)
        for name in levels[z]:
            column = (name[1] * cells - column0) % nodes.columns(z)
            row = (tiles.scheme.tiles_y(z) - 1 - name[2]) * cells - row0
            got = dataset.ReadAsArray(column, row, cells + 1, cells + 1)[::-1].astype(float)
            height, tolerance, doubtful, _ = nodes.tile(*name)
            error = np.where(doubtful, 0.0, np.abs(got - height) - tolerance)
            excess = error - promises.allowed_errors(nodes, name, limits[z]) - promises.FLOAT_SLACK
            if excess.max() > 0:
                faults.append(f"{name}: {error.max()} m, {limits[z]} m are allowed")
    return faults


# Every DEM with tiles of 128 cells, one also with fewer and more.
ROUND_TRIPS = [(name, profile, 128) for profile in ("geodetic", "mercator") for name in dems.DEMS]
ROUND_TRIPS += [("jacksboro", "geodetic", cells) for cells in (64, 256)]


@pytest.mark.parametrize("name, profile, cells", ROUND_TRIPS)
def test_round_trip_within_the_max_error_at_every_node_of_every_zoom(command_set, dem, name, profile, cells):
    folder = command_set(name, "-q", "-p", profile, "--tilesize", cells)
    zooms = sorted(TileSet(folder).levels())
    assert zooms == list(range(len(zooms)))
    nodes = promises.nodes_of(dem(name), profile, cells, zooms[-1])
    promises.none(round_trip_faults(folder, nodes, zooms))


# ---- Open options and missing tiles -----------------------------------------------------------------


@pytest.fixture
def sparse_set(tmp_path):
    """Level 3 has a hole, level 2 has not."""
    writer = pyramid(tmp_path / "sparse", top=2)
    writer.write_level(3, 4, 4, 5, 4).write_level(3, 4, 5, 4, 5)
    return writer.write_layer()


def test_missing_tiles_are_nodata(sparse_set):
    dataset = raster(sparse_set)
    band = dataset.GetRasterBand(1)
    values, mask = band.ReadAsArray(), band.GetMaskBand().ReadAsArray()
    assert (values[:256, 256:] == NODATA).all() and (mask[:256, 256:] == 0).all()
    assert (values[256:] != NODATA).all() and (values[:256, :256] != NODATA).all()
    assert (mask[256:] == 255).all()
    assert band.GetMaskFlags() == gdal.GMF_NODATA


@pytest.mark.parametrize("registration", ["CELL", "NODE"])
def test_or_the_surface_of_the_deepest_ancestor(sparse_set, registration):
    dataset = raster(sparse_set, FILL="PARENT", REGISTRATION=registration)
    assert_plane(dataset.GetRasterBand(1), dataset.GetGeoTransform(), step_of(sparse_set, 2))


def test_nodes_between_a_tile_and_a_missing_one_are_the_tiles(sparse_set):
    values = raster(sparse_set, REGISTRATION="NODE").ReadAsArray()
    assert (values[:257, :257] != NODATA).all()  # the east and south edges, too
    assert (values[:256, 257:] == NODATA).all()
    assert (values[256:] != NODATA).all()


def test_the_file_of_a_listed_tile_is_gone(sparse_set):
    (sparse_set / "3" / "4" / "4.terrain").unlink()
    (sparse_set / "3" / "5" / "4.terrain").unlink()
    with heard() as said:
        values = raster(sparse_set).ReadAsArray()
    assert (values[256:] == NODATA).all()
    assert len(said) == 1 and said[0][0] == gdal.CE_Warning and ".terrain" in said[0][1]
    dataset = raster(sparse_set, FILL="PARENT")
    with heard():
        assert_plane(dataset.GetRasterBand(1), dataset.GetGeoTransform(), step_of(sparse_set, 2))


def test_zoom(sparse_set):
    for z in (0, 1, 2):
        dataset = raster(sparse_set, ZOOM=z)
        assert dataset.RasterXSize == 512 << z
        assert dataset.GetMetadataItem("ZOOM") == str(z) and dataset.GetMetadataItem("MAXZOOM") == "3"


@pytest.mark.parametrize(
    "option, value",
    [("ZOOM", "4"), ("ZOOM", "25"), ("ZOOM", "-1"), ("ZOOM", "two"), ("ZOOM", ""), ("FILL", "CHILD"),
     ("REGISTRATION", "CORNER"), ("GEOMETRY", "LINES")],
)
def test_wrong_values_are_errors(sparse_set, option, value):
    with heard() as said:
        dataset = None
        try:
            dataset = raster(sparse_set, **{option: value})
        except RuntimeError:
            pass
    assert dataset is None
    failures = [text for kind, text in said if kind == gdal.CE_Failure and "QMESH" in text]
    assert len(failures) <= 1


def test_a_wrong_value_is_named(sparse_set):
    with pytest.raises(RuntimeError, match="FILL=CHILD.*NODATA, PARENT"):
        raster(sparse_set, FILL="CHILD")
    with pytest.raises(RuntimeError, match="no tiles of zoom 4"):
        raster(sparse_set, ZOOM=4)


def test_the_driver_lists_its_open_options():
    xml = gdal.GetDriverByName("QMESH").GetMetadataItem("DMD_OPENOPTIONLIST")
    for word in ("ZOOM", "FILL", "REGISTRATION", "GEOMETRY", "<Value>PARENT</Value>", "<Value>TIN</Value>"):
        assert word in xml
    assert gdal.ParseXMLString(xml) is not None


# ---- What is read -----------------------------------------------------------------------------------


def test_a_window_reads_its_tiles_only(sparse_set):
    """A damaged tile outside the window does no harm."""
    (sparse_set / "3" / "4" / "5.terrain").write_bytes(b"damaged")
    dataset = raster(sparse_set)
    assert (dataset.ReadAsArray(0, 256, 512, 256) != NODATA).all()
    with pytest.raises(RuntimeError, match="3/4/5.terrain"):
        dataset.ReadAsArray(0, 0, 256, 256)


def test_a_window_of_a_deep_set_is_quick(tmp_path):
    """Nothing is made for tiles that are only listed."""
    writer = Writer(tmp_path)
    writer.write_tile(20, 5, 3)
    writer.available = [[{"startX": 0, "startY": 0, "endX": (2 << z) - 1, "endY": (1 << z) - 1}] for z in range(21)]
    dataset = raster(writer.write_layer(), ZOOM=20)
    rows = dataset.RasterYSize
    values = dataset.ReadAsArray(5 * 256, rows - 4 * 256, 256, 256)
    assert (values != NODATA).all()


def test_a_level_too_large_for_a_raster_is_not_the_default(tmp_path):
    writer = pyramid(tmp_path, top=0)
    writer.available = [[{"startX": 0, "startY": 0, "endX": (2 << z) - 1, "endY": (1 << z) - 1}] for z in range(25)]
    folder = writer.write_layer()
    assert raster(folder).GetMetadataItem("ZOOM") == "21"
    with pytest.raises(RuntimeError, match="ZOOM"):
        raster(folder, ZOOM=24)


def test_statistics(small_set):
    dataset = raster(small_set)
    band = dataset.GetRasterBand(1)
    values = band.ReadAsArray()
    low, high, mean, deviation = band.ComputeStatistics(False)
    assert (low, high) == (values.min(), values.max())
    assert mean == pytest.approx(values.mean(dtype=float)) and deviation == pytest.approx(values.std(dtype=float), rel=1e-6)
    assert sorted(file.name for file in small_set.iterdir()) == ["0", "1", "2", "layer.json"]


def test_each_thread_with_its_own_dataset(command_set):
    folder = command_set("jacksboro", "-q", "--tilesize", 64)
    expected = raster(folder).ReadAsArray()
    wrong = []

    def read(offset):
        for _ in range(3):
            dataset = raster(folder)
            if not np.array_equal(dataset.ReadAsArray(offset, 0, 256, 512), expected[:, offset : offset + 256]):
                wrong.append(offset)

    threads = [threading.Thread(target=read, args=(32 * k,)) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_datasets_are_closed_with_nothing_left(small_set):
    """Opened and dropped many times: no file stays open."""
    import os

    before = len(os.listdir("/proc/self/fd"))
    for _ in range(50):
        raster(small_set).ReadAsArray(0, 0, 10, 10)
    assert len(os.listdir("/proc/self/fd")) <= before + 1


# ---- The utilities ----------------------------------------------------------------------------------


def run(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    assert "ERROR" not in done.stderr, done.stderr
    return done.stdout


def test_the_utilities_of_gdal_work(command_set, tmp_path):
    folder = command_set("jacksboro", "-q", "--tilesize", 64)
    dataset = raster(folder)
    values = dataset.ReadAsArray()
    run("gdaldem", "hillshade", "-q", "-s", 111120, folder, tmp_path / "shade.tif")
    assert gdal.Open(str(tmp_path / "shade.tif")).ReadAsArray()[200:300, 200:300].std() > 1
    run("gdalwarp", "-q", "-t_srs", "EPSG:32616", folder, tmp_path / "warped.tif")
    assert gdal.Open(str(tmp_path / "warped.tif")).ReadAsArray().max() == pytest.approx(values.max(), abs=5)
    x, y = centres(dataset.GetRasterBand(1), dataset.GetGeoTransform())
    told = run("gdallocationinfo", "-valonly", "-wgs84", folder, x[100], y[200])
    assert float(told) == pytest.approx(values[200, 100], rel=1e-6)
    run("gdal_translate", "-q", folder, tmp_path / "copy.tif")
    assert np.array_equal(gdal.Open(str(tmp_path / "copy.tif")).ReadAsArray(), values)
    run(sys.executable, "-m", "osgeo_utils.gdal2xyz", folder, tmp_path / "points.xyz")
    first = (tmp_path / "points.xyz").read_text().split()[:3]
    assert float(first[2]) == pytest.approx(values[0, 0], rel=1e-6)
    layer = folder / "layer.json"
    assert "Differences Found: 0" in run(sys.executable, "-m", "osgeo_utils.gdalcompare", layer, layer)
    assert "Overviews: 256x256" in run("gdalinfo", folder)


def test_a_set_reads_back_what_another_raster_of_it_would(command_set):
    """The driver's cells against a raster of the same surface made by the oracle of the tests."""
    from oracle import tin

    folder = command_set("jacksboro", "-q", "--tilesize", 64, "-p", "mercator")
    tiles = TileSet(folder)
    top = max(tiles.levels())
    dataset = raster(folder)
    half = mercator_half()
    west, res, _, north = dataset.GetGeoTransform()[:4]
    scheme = Scheme("mercator")
    for _, x, y in tiles.levels()[top][::7]:
        v = scheme.node_v(top, y, 128)[1::2]
        u = 32767 * (np.arange(64) + 0.5) / 64
        expected = tin.evaluate(tiles.tile(top, x, y), u, v)
        column = round((2 * half * x / 2**top - half - west) / res)
        row = round((north - (2 * half * (y + 1) / 2**top - half)) / res)
        got = dataset.ReadAsArray(column, row, 64, 64)[::-1]
        assert np.abs(got - expected).max() < 1e-3


