# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""qmeshinfo: description, JSON, one tile, exports, samples, exit codes and bad input."""

import functools
import http.server
import json
import math
import os
import signal
import subprocess
import threading
import xml.etree.ElementTree as Xml

import infos
import jsonschema
import numpy as np
import pytest
from infos import CLEAN, INPUT, OUTPUT, USAGE, info_json, qmeshinfo, refused
from made_set import MadeSet, box_of, make_tile
from osgeo import gdal

ROOT_OPTIONS = ("--tilesize", "16", "-z", "0-8")


@pytest.fixture(scope="module")
def ours(tile_set):
    """A set of gdal2qmesh, small."""
    return tile_set("jacksboro", *ROOT_OPTIONS, "-c", "NASA")


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    return MadeSet().write(tmp_path_factory.mktemp("made") / "set")


def valid_json(*args, **kwargs):
    report = info_json(*args, **kwargs)
    jsonschema.validate(report, json.loads(infos.SCHEMA.read_text(encoding="utf-8")))
    return report


def test_schema_is_strict():
    schema = json.loads(infos.SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    for wrong in ({}, {"program": "qmeshinfo", "version": "1", "set": "a", "more": 1}):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(wrong, schema)


def test_our_sets_have_no_errors_or_warnings(ours):
    report = valid_json("--validate", ours.folder)["validation"]
    assert [f["code"] for f in report["findings"]] == ["QM611"], report["findings"]
    assert report["largestGap"] < 1e-3 and report["seams"] > 3
    assert report["tiles"] == len(ours.available())


@pytest.mark.parametrize("more", [(), ("-p", "mercator"), ("--xyz", "--metadata", "2")])
def test_our_globes_have_no_errors_or_warnings(tile_set, more):
    tiles = tile_set("global", "--tilesize", "32", "-z", "0-3", *more)
    report = valid_json("--validate", tiles.folder)["validation"]
    assert report["errors"] == report["warnings"] == 0, report["findings"]
    assert report["tiles"] == len(tiles.available())


def test_description_is_layer_json(ours):
    report = valid_json(ours.folder)
    layer = ours.layer
    assert report["layer"]["name"] == layer["name"]
    assert report["layer"]["attribution"] == "NASA"
    assert report["layer"]["version"] == layer["version"]
    assert report["layer"]["bounds"] == layer["bounds"]
    assert report["layer"]["method"] == "greedy" and report["layer"]["cellsPerTile"] == 16
    assert [level["tiles"] for level in report["levels"]] == [len(t) for t in ours.levels().values()]
    assert [level["maxError"] for level in report["levels"]] == [e["maxError"] for e in layer["qmesh"]["levels"]]
    assert "stats" not in report and "validation" not in report
    text = qmeshinfo(ours.folder).out
    for words in ("Name: ", "NASA", layer["version"], "EPSG:4326", "octvertexnormals", "greedy"):
        assert words in text


def test_description_needs_no_tile(tmp_path, made):
    (tmp_path / "layer.json").write_bytes((made / "layer.json").read_bytes())
    assert [level["tiles"] for level in valid_json(tmp_path)["levels"]] == [2, 1, 4]


def test_statistics(ours):
    report = valid_json("--stats", ours.folder)["stats"]
    for level, (z, names) in zip(report["levels"], ours.levels().items()):
        tiles = [ours.tile(*name) for name in names]
        assert level["zoom"] == z and level["tiles"] == len(tiles)
        assert level["triangles"] == sum(len(t.triangles) for t in tiles)
        assert level["vertices"] == sum(len(t.u) for t in tiles)
        assert level["bytes"] == sum(ours.path(*name).stat().st_size for name in names)
        assert level["lowest"] == pytest.approx(min(t.heights().min() for t in tiles))
        assert level["highest"] == pytest.approx(max(t.heights().max() for t in tiles))
        assert level["normals"] == level["compressed"] == len(tiles)
    one = valid_json("--stats", "-z", "3", ours.folder)["stats"]
    assert [level["zoom"] for level in one["levels"]] == [3]


def test_every_name_of_a_set(made, monkeypatch):
    monkeypatch.chdir(made)
    want = valid_json(made)["levels"]
    for path in (made / "layer.json", f"QMESH:{made}", ".", "layer.json"):
        assert valid_json(path)["levels"] == want
    tile = valid_json("2/4/2.terrain")
    assert tile["tile"]["tile"] == "2/4/2" and "layer" not in tile


def test_archive(tmp_path, made):
    import shutil

    archive = shutil.make_archive(str(tmp_path / "set"), "zip", made)
    report = valid_json("--validate", f"/vsizip/{archive}")
    assert report["validation"]["tiles"] == 7 and report["validation"]["findings"] == []


def test_server(made):
    handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=str(made))
    handler.log_message = lambda *a: None
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_address[1]}"
        report = valid_json("--validate", address)
        assert report["validation"]["tiles"] == 7 and report["validation"]["findings"] == []
        assert valid_json(f"{address}/layer.json")["layer"]["name"] == "made"
        refused(qmeshinfo(f"{address}/nowhere"), INPUT, "nowhere")
        server.shutdown()


# ---- one tile ---------------------------------------------------------------------------------------------------


def test_tile_header(made):
    want = MadeSet().tiles[2, 4, 2]
    tile = valid_json("--tile", "2/4/2", made)["tile"]
    assert tile["box"] == list(want.box)
    assert tile["vertices"] == 81 and tile["triangles"] == 128
    assert tile["edgeVertices"] == [9, 9, 9, 9] and tile["extensions"] == [1]
    assert tile["minHeight"] == 0 and tile["lowest"] == pytest.approx(100) and tile["highest"] == pytest.approx(145)
    assert np.allclose(tile["sphere"]["centre"], want.sphere) and np.allclose(tile["horizon"], want.horizon)
    assert tile["bytes"] == tile["unpackedBytes"] == len(want.encode()) and not tile["compressed"]
    text = qmeshinfo("--tile", "2/4/2", made).out
    assert text.startswith("Tile: 2/4/2\n") and "Triangles: 128\n" in text


def read_obj(path):
    lines = path.read_text().splitlines()
    numbers = [list(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]
    faces = [[int(c.split("/")[0]) - 1 for c in line.split()[1:]] for line in lines if line.startswith("f ")]
    return np.array(numbers), np.array(faces)


def read_off(path):
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    assert lines[0] == "OFF"
    vertices, faces, _ = map(int, lines[1].split())
    points = np.array([list(map(float, line.split())) for line in lines[2 : 2 + vertices]])
    return points, np.array([list(map(int, line.split()[1:])) for line in lines[2 + vertices :]])


def read_ply(path):
    head, body = path.read_text().split("end_header\n")
    vertices = int(head.split("element vertex ")[1].split()[0])
    lines = body.splitlines()
    points = np.array([list(map(float, line.split()[:3])) for line in lines[:vertices]])
    return points, np.array([list(map(int, line.split()[1:])) for line in lines[vertices:]])


READERS = {"obj": read_obj, "off": read_off, "ply": read_ply}


@pytest.mark.parametrize("form", READERS)
def test_export(tmp_path, ours, form):
    name = max(ours.available())
    tile = ours.tile(*name)
    at = "/".join(map(str, name))
    file = tmp_path / f"tile.{form}"
    assert qmeshinfo("--tile", at, "--export", file, "--frame", "ecef", ours.folder).code == CLEAN
    points, faces = READERS[form](file)
    assert np.allclose(points, tile.ecef(ours.scheme.box(*name)), atol=1e-3)
    assert np.array_equal(faces, tile.triangles)
    qmeshinfo("--tile", at, "--export", file, "--frame", "lonlat", ours.folder)
    points, _ = READERS[form](file)
    west, south, east, north = ours.scheme.box(*name)
    assert points[:, 0].min() == pytest.approx(west) and points[:, 1].max() == pytest.approx(north)
    assert np.allclose(points[:, 2], tile.heights(), atol=1e-4)
    qmeshinfo("--tile", at, "--export", file, ours.folder)
    points, _ = READERS[form](file)
    a, b, c = (points[faces[:, k]] for k in range(3))
    assert (np.cross(b - a, c - a)[:, 2] > 0).all(), "seen from above, counter-clockwise"


def test_drawing(tmp_path, ours):
    name = "/".join(map(str, max(ours.available())))
    triangles = valid_json("--tile", name, ours.folder)["tile"]["triangles"]
    svg = tmp_path / "tile.svg"
    assert qmeshinfo("--tile", name, "--draw", svg, "--width", 300, ours.folder).code == CLEAN
    group = Xml.parse(svg).getroot().find("{http://www.w3.org/2000/svg}g")
    assert len(group) == triangles
    pixels = {}
    for shade in ("height", "slope", "none"):
        png = tmp_path / f"{shade}.png"
        assert qmeshinfo("--tile", name, "--draw", png, "--width", 300, "--shade", shade, ours.folder).code == CLEAN
        pixels[shade] = gdal.Open(str(png)).ReadAsArray()
        assert pixels[shade].shape[0] == 3 and pixels[shade].shape[2] == 300
        assert (pixels[shade][0, 0] > 190).all() and (pixels[shade][1, 0] < 60).all(), "the border is red"
    assert (pixels["height"] != pixels["slope"]).any()
    assert not [p for p in tmp_path.iterdir() if p.suffix == ".xml"]


def test_tile_that_is_not_there(made):
    refused(qmeshinfo("--tile", "2/0/0", made), INPUT, "2/0/0")
    refused(qmeshinfo("--tile", "2/99/0", made), INPUT, "8 columns")


# ---- places -----------------------------------------------------------------------------------------------------


def test_samples(made):
    samples = valid_json("--sample", "10,20", "--sample", "-100,-45", "--sample", "-350,20", made)["samples"]
    assert [s["tile"] for s in samples] == ["2/4/2", "0/0/0", "2/4/2"]
    assert samples[0]["height"] == pytest.approx(120, abs=0.01)
    assert samples[1]["height"] == pytest.approx(55, abs=0.01)
    assert samples[2]["height"] == samples[0]["height"]
    high = valid_json("--sample", "10,20", "-z", "1", made)["samples"]
    assert high[0]["tile"] == "1/2/1"


def test_samples_from_standard_input(made):
    run = qmeshinfo("--sample", "-", made, text="10 20\n\n-100;-45\n")
    assert [line.split()[3] for line in run.out.splitlines()] == ["2/4/2", "0/0/0"]
    refused(qmeshinfo("--sample", "-", made, text="here\n"), USAGE, "here")


def test_places_on_every_corner(made):
    for lon in (-180, 0, 45, 90, 180):
        for lat in (-90, 0, 45, 90):
            sample = valid_json("--sample", f"{lon},{lat}", made)["samples"][0]
            assert sample["height"] == pytest.approx(100 + lat, abs=0.02), sample


def test_place_without_terrain(tmp_path):
    made = MadeSet()
    del made.tiles[0, 0, 0]
    folder = made.write(tmp_path / "set")
    assert qmeshinfo("--sample", "-100,0", folder).out == "-100 0 - -\n"
    assert valid_json("--sample", "-100,0", folder)["samples"] == [{"lon": -100, "lat": 0, "height": None}]


# ---- sets of other programs ---------------------------------------------------------------------------------------


def test_foreign_set_without_what_may_be_absent(tmp_path):
    """layer.json with the three keys CesiumJS needs, tiles without normals."""
    made = MadeSet()
    made.layer = {key: made.layer[key] for key in ("format", "available")}
    made.layer["tiles"] = ["{z}/{x}/{y}.terrain"]
    for tile in made.tiles.values():
        tile.extensions = []
    folder = made.write(tmp_path / "set")
    assert valid_json("--stats", folder)["stats"]["tiles"] == 7
    seen, code = infos.findings(folder)
    assert set(seen) == {"QM118", "QM123"} and code == CLEAN


def test_foreign_set_of_an_old_server(tmp_path):
    """Normals called vertexnormals, lengths big-endian."""
    made = MadeSet()
    made.layer["extensions"] = ["vertexnormals"]
    made.raw = {name: tile.encode(lengths=">") for name, tile in made.tiles.items()}
    folder = made.write(tmp_path / "set")
    assert [level["normals"] for level in valid_json("--stats", folder)["stats"]["levels"]] == [2, 1, 4]


def test_foreign_set_with_wide_indices(tmp_path):
    """More than 65536 vertices: 32-bit indices, aligned."""
    made = MadeSet()
    tile = make_tile(box_of(2, 4, 2), 256)
    made.tiles[2, 4, 2] = tile
    made.raw[2, 4, 2] = tile.encode(index_bytes=4)
    folder = made.write(tmp_path / "set")
    seen, code = infos.findings(folder)
    assert set(seen) <= {"QM501", "QM502"} and code == CLEAN
    assert valid_json("--tile", "2/4/2", folder)["tile"]["vertices"] == 257 * 257


def test_rows_from_the_north(tmp_path):
    made = MadeSet()
    made.layer["scheme"] = "slippyMap"
    made.tiles = {(z, x, 2**z - 1 - y): tile for (z, x, y), tile in made.tiles.items()}
    folder = made.write(tmp_path / "set")
    assert infos.findings(folder) == ({}, CLEAN)
    assert valid_json("--tile", "2/4/2", folder)["tile"]["file"].endswith("2/4/1.terrain")


def test_set_of_which_only_the_roots_list_tiles(tmp_path):
    made = MadeSet()
    made.add_metadata()
    del made.layer["available"]
    folder = made.write(tmp_path / "set")
    report = valid_json("--validate", folder)
    assert report["validation"]["tiles"] == 7 and report["validation"]["findings"] == []


def test_faults_of_layer_json_are_said_in_a_description(tmp_path):
    made = MadeSet()
    made.layer["scheme"] = "xyz"
    run = qmeshinfo(made.write(tmp_path / "set"))
    assert run.code == CLEAN and "qmeshinfo: warning: QM106: " in run.err


# ---- bad input ----------------------------------------------------------------------------------------------------


def test_unreadable_sets(tmp_path):
    refused(qmeshinfo(tmp_path), INPUT, "layer.json")
    refused(qmeshinfo(tmp_path / "nowhere"), INPUT, "nowhere")
    (tmp_path / "layer.json").write_text("{")
    refused(qmeshinfo(tmp_path), INPUT, "layer.json")
    (tmp_path / "0" / "0").mkdir(parents=True)
    (tmp_path / "0" / "0" / "0.terrain").write_bytes(b"\x00" * 50)
    refused(qmeshinfo(tmp_path / "0" / "0" / "0.terrain"), INPUT, "QM204")
    refused(qmeshinfo("--stats", tmp_path), INPUT, "0.terrain")
    refused(qmeshinfo(tmp_path / "tile.terrain"), INPUT, "zoom/column/row")


@pytest.mark.parametrize("args", [(), ("--export", "a.obj"), ("--tile", "1"), ("--unknown",), ("--sample", "x"),
                                  ("--error-raster", "e.tif"), ("--tile", "0/0/0", "--draw", "a.gif")])
def test_usage(made, args):
    refused(qmeshinfo(*args, *([made] if args else [])), USAGE)


def test_zooms_that_are_not_there(made):
    refused(qmeshinfo("-z", "20", made), USAGE, "no zoom 20", "deepest")
    assert qmeshinfo("-z", "0-20", made).code == CLEAN


def test_places_that_cannot_be_written(tmp_path, made):
    for option, name in (("--export", "a.obj"), ("--draw", "a.svg"), ("--draw", "a.png")):
        (tmp_path / name).mkdir(exist_ok=True)
        refused(qmeshinfo("--tile", "0/0/0", option, tmp_path / name, made), OUTPUT, name)


def test_malformed_tiles_end_cleanly(tmp_path):
    """Every shorter file and random bytes: a report, never a crash."""
    made = MadeSet()
    good = made.tiles[2, 4, 2].encode()
    folder = made.write(tmp_path / "set")
    file = folder / "2" / "4" / "2.terrain"
    random = np.random.default_rng(3)
    for k in range(60):
        data = bytearray(good)
        for place in random.integers(0, len(good), 1 + k % 5):
            data[place] = random.integers(0, 256)
        file.write_bytes(bytes(data[: len(good) - (k % 7) * 150]))
        run = qmeshinfo("-q", "--validate", folder)
        assert run.code in (0, 1), f"{k}: {run.code} {run.err}"


def test_help_and_version():
    assert qmeshinfo("--version").out.startswith("qmeshinfo ")
    text = qmeshinfo("--help").out
    assert text.startswith("usage: qmeshinfo [options] TILESET\n") and "--error-raster" in text
    assert json.loads(qmeshinfo("--options-json").out)["program"] == "qmeshinfo"


def test_interrupt_ends_with_3(tmp_path):
    made = MadeSet()
    tiles = {(0, 0, 0): made.tiles[0, 0, 0], (0, 1, 0): made.tiles[0, 1, 0]}
    made.tiles = tiles
    made.layer["available"] = [[made.range(0, 0, 2 ** (z + 1) - 1, 2**z - 1)] for z in range(12)]
    folder = made.write(tmp_path / "set")
    run = subprocess.Popen([str(infos.BIN), "--validate", "-j", "1", str(folder)], stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE)
    threading.Timer(0.5, lambda: os.kill(run.pid, signal.SIGINT)).start()
    out, err = run.communicate(timeout=60)
    assert run.returncode == 3 and out == b"" and b"stopped" in err


# ---- against a DEM ------------------------------------------------------------------------------------------------

OFF = 5.0  # metres by which the terrain is too low


def ramp(path, nodata_rows=0, box=(10, 20, 60, 70), size=100, srs="EPSG:4326"):
    """A DEM OFF metres above the made set; square degrees, or metres of Mercator."""
    west, south, east, north = box
    data = gdal.GetDriverByName("GTiff").Create(str(path), size, size, 1, gdal.GDT_Float64)
    data.SetGeoTransform((west, (east - west) / size, 0, north, 0, (south - north) / size))
    data.SetProjection(gdal.osr.GetUserInputAsWKT(srs))
    rows = north + (south - north) / size * (np.arange(size) + 0.5)
    if srs == "EPSG:3857":
        rows = np.degrees(2 * np.arctan(np.exp(rows / 6378137)) - math.pi / 2)
    heights = np.repeat((100 + OFF + rows)[:, None], size, 1)
    heights[:nodata_rows] = -9999
    data.GetRasterBand(1).SetNoDataValue(-9999)
    data.GetRasterBand(1).WriteArray(heights)
    return path


def test_error_of_a_known_displacement(tmp_path, made):
    raster = tmp_path / "error.tif"
    report = valid_json("--dem", ramp(tmp_path / "dem.tif", 10), "--error-raster", raster, made)["dem"]
    assert report["step"] == 1 and report["cells"] == 10000 and report["voids"] == 1000
    assert [level["zoom"] for level in report["levels"]] == [0, 1, 2]
    for level in report["levels"]:
        assert level["cells"] == 9000 and level["uncovered"] == 0
        for key in ("max", "rms", "p99"):
            assert level[key] == pytest.approx(OFF, abs=0.01)
        assert level["mean"] == pytest.approx(-OFF, abs=0.01)
    error = gdal.Open(str(raster))
    assert error.GetGeoTransform() == gdal.Open(str(tmp_path / "dem.tif")).GetGeoTransform()
    values = error.ReadAsArray()
    assert np.isnan(values[:10]).all() and np.allclose(values[10:], -OFF, atol=0.01)


def test_error_in_another_crs_and_by_steps(tmp_path, made):
    dem = ramp(tmp_path / "dem.tif", box=(1e6, 2e6, 7e6, 8e6), srs="EPSG:3857")
    report = valid_json("--dem", dem, "--dem-step", 7, "-z", "2", "--error-raster", tmp_path / "e.tif", made)["dem"]
    assert report["step"] == 7 and report["cells"] == 14 * 14
    (level,) = report["levels"]
    assert level["max"] == pytest.approx(OFF, abs=0.01) and level["uncovered"] == 0
    error = gdal.Open(str(tmp_path / "e.tif"))
    assert (error.RasterXSize, error.RasterYSize) == (14, 14)
    assert error.GetGeoTransform()[1] == 7 * 60000


def test_one_bad_cell_is_the_largest_error(tmp_path, made):
    dem = ramp(tmp_path / "dem.tif")
    data = gdal.Open(str(dem), gdal.GA_Update)
    data.GetRasterBand(1).WriteArray(np.array([[1000.0]]), 30, 40)
    data = None
    for level in valid_json("--dem", dem, made)["dem"]["levels"]:
        assert level["maxAt"] == pytest.approx([10 + 30.5 * 0.5, 70 - 40.5 * 0.5])
        assert level["max"] == pytest.approx(1000 - 100 - (70 - 40.5 * 0.5), abs=0.01)
        assert level["p99"] == pytest.approx(OFF, abs=0.01)


def test_cells_outside_the_level_are_counted(tmp_path, made):
    report = valid_json("--dem", ramp(tmp_path / "dem.tif", box=(-20, 20, 20, 60)), made)["dem"]
    assert [level["uncovered"] for level in report["levels"]] == [0, 5000, 5000]


def test_error_does_not_depend_on_threads(tmp_path, ours):
    args = ("--dem", "data/jacksboro_srtm3.tif", ours.folder)
    os.chdir(infos.harness.ROOT)
    assert info_json("-j", 1, *args) == info_json("-j", 3, *args)


def test_dem_options_are_those_of_gdal2qmesh(tmp_path, made):
    dem = ramp(tmp_path / "dem.tif")
    report = valid_json("--dem", dem, "--bathymetry", "-z", "2", made)["dem"]
    assert report["levels"][0]["mean"] == pytest.approx(2 * (100 + 45) + OFF, abs=0.02)
    refused(qmeshinfo("--dem", tmp_path / "none.tif", made), INPUT, "none.tif")
    refused(qmeshinfo("--dem", dem, "-b", "2", made), INPUT, "band")
    refused(qmeshinfo("--dem", dem, "--error-raster", tmp_path / "no" / "e.tif", made), OUTPUT, "e.tif")
