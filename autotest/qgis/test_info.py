# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The algorithms on qmeshinfo: Terrain information and validation, Measure error against DEM."""

import json
import subprocess

import pytest
from conftest import BUILD, DEM
from osgeo import gdal

INFO = BUILD / "bin" / "qmeshinfo"


@pytest.fixture(scope="module")
def terrain(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sets") / "terrain"
    subprocess.run([BUILD / "bin" / "gdal2qmesh", "-q", "-z", "0-8", "--tilesize", "64", DEM, folder], check=True)
    return folder


@pytest.fixture
def damaged(tmp_path):
    folder = tmp_path / "damaged"
    subprocess.run([BUILD / "bin" / "gdal2qmesh", "-q", "-z", "0-5", "--tilesize", "64", DEM, folder], check=True)
    tile = sorted(folder.glob("5/*/*.terrain"))[0]
    tile.write_bytes(tile.read_bytes()[:200])
    return folder


def asked(*words):
    done = subprocess.run([INFO, "--json", *map(str, words)], capture_output=True, check=False)
    return json.loads(done.stdout)


def test_a_good_set_in_qgis_process(run_process, terrain, tmp_path):
    process = run_process("qmesh:info", INPUT=terrain, JSON=tmp_path / "i.json", REPORT=tmp_path / "i.html")
    results = process.succeeded()
    own = asked("--stats", "--validate", terrain)
    assert json.loads((tmp_path / "i.json").read_text()) == own
    assert results["VALID"] == "true" and results["ERRORS"] == "0"
    assert int(results["TILES"]) == len(list(terrain.rglob("*.terrain")))
    page = (tmp_path / "i.html").read_text()
    assert "<h3>Levels</h3>" in page and "0 errors" in page and "jacksboro" in page


def test_one_tile_alone(run_process, terrain, tmp_path):
    tile = max(terrain.glob("8/*/*.terrain"), key=lambda path: path.stat().st_size)
    results = run_process("qmesh:info", INPUT=tile, REPORT=tmp_path / "i.html").succeeded()
    own = asked("--stats", "--validate", tile)["tile"]
    assert (results["TILES"], results["VALID"]) == ("1", "true")
    assert int(results["TRIANGLE_COUNT"]) == own["triangles"] > 0
    page = (tmp_path / "i.html").read_text()
    assert own["tile"] in page and str(own["vertices"]) in page and "0 errors" in page
    measured = run_process("qmesh:measure", INPUT=tile, DEM=DEM).succeeded()
    assert measured["ZOOM_MEASURED"] == "8"


def test_a_damaged_set_is_no_failure_but_not_valid(qgis, feedback, damaged):
    import processing

    told = []
    feedback.reportError = lambda text, fatal=False: told.append(text)
    results = processing.run("qmesh:info", {"INPUT": str(damaged), "REPORT": "TEMPORARY_OUTPUT"}, feedback=feedback)
    own = asked("--stats", "--validate", damaged)["validation"]
    assert not results["VALID"] and results["ERRORS"] == own["errors"] > 0
    for finding in own["findings"]:
        if finding["severity"] == "error":
            assert any(finding["code"] in text for text in told), told
    with open(results["REPORT"], encoding="utf-8") as file:
        assert "class='error'" in file.read()


def test_description_alone(qgis, terrain):
    import processing

    results = processing.run("qmesh:info", {"INPUT": str(terrain), "STATS": False, "VALIDATE": False})
    assert "VALID" not in results and "BYTES" not in results and results["TILES"] > 0


def test_measure_in_qgis_process(run_process, terrain, tmp_path):
    process = run_process(
        "qmesh:measure", INPUT=terrain, DEM=DEM, ERROR_RASTER=tmp_path / "e.tif", REPORT=tmp_path / "m.html"
    )
    results = process.succeeded()
    deepest = asked("--dem", DEM, terrain)["dem"]["levels"][-1]
    assert float(results["MAX"]) == deepest["max"] and float(results["RMS"]) == deepest["rms"]
    assert results["ZOOM_MEASURED"] == "8"
    raster = gdal.Open(str(tmp_path / "e.tif"))
    low, high = raster.GetRasterBand(1).ComputeRasterMinMax()
    assert max(-low, high) == pytest.approx(deepest["max"], abs=0.01)
    assert "rms m" in (tmp_path / "m.html").read_text()


def test_measure_in_python_with_a_layer(qgis, feedback, terrain):
    import processing
    from qgis.core import QgsRasterLayer

    results = processing.run(
        "qmesh:measure", {"INPUT": str(terrain), "DEM": QgsRasterLayer(str(DEM), "dem"), "ZOOM": "5-7"}, feedback=feedback
    )
    levels = asked("--dem", DEM, "-z", "5-7", terrain)["dem"]["levels"]
    assert results["ZOOM_MEASURED"] == 7 and results["P99"] == levels[-1]["p99"]
    assert feedback.percents and feedback.percents[-1] == 100


def test_wrong_input(run_process, terrain, tmp_path):
    run_process("qmesh:info", INPUT=tmp_path / "none").failed(str(tmp_path / "none"))
    (tmp_path / "text.tif").write_text("no raster")
    run_process("qmesh:measure", INPUT=terrain, DEM=tmp_path / "text.tif").failed("text.tif")
    run_process("qmesh:measure", INPUT=terrain).failed("DEM")


def test_missing_command(run_process, terrain, tmp_path):
    environment = {"PATH": "/usr/bin:/bin"}
    for algorithm in ("qmesh:info", "qmesh:measure"):
        process = run_process(algorithm, environment, INPUT=terrain)
        process.failed("qmeshinfo was not found on PATH or beside the plugin")


def test_cancel(qgis, feedback, terrain):
    import processing

    feedback.cancel()
    assert "VALID" not in processing.run("qmesh:info", {"INPUT": str(terrain)}, feedback=feedback)
