# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The algorithm Generate: the same tiles as the command, and everything a user of QGIS may do to it."""

import hashlib
import json
import os
import pathlib
import subprocess
import sys
import threading
import time

import pytest
from conftest import BUILD, DEM

HERE = pathlib.Path(__file__).resolve().parent
COMMAND = BUILD / "bin" / "gdal2qmesh"
SMALL = {"TILESIZE": "64", "MAX_ZOOM": 8}


def tree(folder):
    return {
        p.relative_to(folder).as_posix(): hashlib.sha256(p.read_bytes()).hexdigest()
        for p in sorted(folder.rglob("*"))
        if p.is_file()
    }


def by_command(folder, *options):
    subprocess.run([COMMAND, *options, DEM, folder], check=True, stdout=subprocess.DEVNULL)
    return tree(folder)


def generate(feedback=None, **parameters):
    import processing

    return processing.run("qmesh:generate", {"INPUT": str(DEM), **SMALL, **parameters}, feedback=feedback)


def raises(message, feedback=None, **parameters):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException) as caught:
        generate(feedback, **parameters)
    assert message in str(caught.value)
    return str(caught.value)


def test_qgis_process_makes_the_tiles_of_the_command(run_process, tmp_path):
    results = run_process("qmesh:generate", INPUT=DEM, OUTPUT=tmp_path / "a", **SMALL, MAX_ERROR="5").succeeded()
    expected = by_command(tmp_path / "b", "--tilesize", "64", "--max-zoom", "8", "--max-error", "5")
    assert tree(tmp_path / "a") == expected
    assert int(results["TILES"]) == sum(name.endswith(".terrain") for name in expected)


def test_python_makes_the_tiles_of_the_command(qgis, feedback, tmp_path):
    results = generate(
        feedback, OUTPUT=str(tmp_path / "a"), BATHYMETRY=True, NORMALS=False, DECIMATE=False, PROFILE="mercator",
        CLIP_LOW=-700.5, TITLE="two words", REPORT=str(tmp_path / "report.json"),
    )
    expected = by_command(
        tmp_path / "b", "--tilesize", "64", "--max-zoom", "8", "--bathymetry", "--no-normals", "--decimate", "off",
        "-p", "mercator", "--clip-low", "-700.5", "-t", "two words",
    )
    assert tree(tmp_path / "a") == expected
    assert results["REPORT"] == str(tmp_path / "report.json")
    assert json.loads((tmp_path / "report.json").read_text())["total"]["bytes"] == results["BYTES"]
    assert feedback.percents and feedback.percents == sorted(feedback.percents) and feedback.percents[-1] == 100


def test_defaults_of_the_form_are_those_of_the_command(qgis, feedback, tmp_path):
    """Every parameter with its default, as the dialog hands them over."""
    from qgis.core import QgsApplication

    algorithm = QgsApplication.processingRegistry().algorithmById("qmesh:generate")
    defaults = {p.name(): p.defaultValue() for p in algorithm.parameterDefinitions()}
    generate(feedback, **{**defaults, "INPUT": str(DEM), **SMALL, "OUTPUT": str(tmp_path / "a")})
    said = next(line for line in feedback.lines if line.startswith("gdal2qmesh "))
    options = [word for word in said.split() if word.startswith("--")]
    assert sorted(options) == ["--max-zoom", "--report", "--tilesize"]


def test_extent_in_another_crs(qgis, tmp_path):
    box = (-84.3, 36.2, -84.2, 36.4)
    generate(OUTPUT=str(tmp_path / "a"), TE="-84.3,-84.2,36.2,36.4 [EPSG:4326]", S_SRS="EPSG:4326")
    expected = by_command(
        tmp_path / "b", "--tilesize", "64", "--max-zoom", "8", "--te", *map(str, box), "--te-srs", "EPSG:4326",
        "-s", "EPSG:4326",
    )
    assert tree(tmp_path / "a") == expected


def test_table_of_values_per_zoom(qgis, tmp_path):
    cells = ["max-error", "0-6", "2000/2^z", "screen-error", "", "", "Max error [m]", "7", 20, "--max-error", "8-", "3.5"]
    generate(OUTPUT=str(tmp_path / "a"), PER_ZOOM=cells)
    expected = by_command(tmp_path / "b", "--tilesize", "64", "--max-zoom", "8", "--max-error", "0-6:2000/2^z,7:20,8-:3.5")
    assert tree(tmp_path / "a") == expected


@pytest.mark.parametrize(
    "cells, message",
    [
        (["max-eror", "0-", "5"], "names 'max-eror'; expected one of max-error, screen-error"),
        (["max-error", "", "5"], "a line of max-error without zooms"),
        (["max-error", "0-", ""], "a line of max-error without value"),
        (["max-error", "0-"], "three a line"),
        (["max-error", "5-", "3"], "max-error"),  # zooms 0-4 are missing: the command says so
    ],
)
def test_a_wrong_table_is_refused(qgis, tmp_path, cells, message):
    raises(message, OUTPUT=str(tmp_path / "a"), PER_ZOOM=cells)
    assert not (tmp_path / "a").exists()


def test_a_value_and_a_table_are_one_too_many(qgis, tmp_path):
    raises("max-error is given twice", OUTPUT=str(tmp_path / "a"), MAX_ERROR="5", PER_ZOOM=["max-error", "0-", "5"])


def test_layers_of_a_project(qgis, tmp_path):
    """A raster layer with open options, a cutline of a memory layer."""
    from qgis.core import QgsFeature, QgsGeometry, QgsRasterLayer, QgsVectorLayer

    raster = QgsRasterLayer(f"{DEM}|option:NUM_THREADS=1", "dem")
    polygons = QgsVectorLayer("Polygon?crs=EPSG:4326", "area", "memory")
    feature = QgsFeature()
    feature.setGeometry(QgsGeometry.fromWkt("POLYGON((-84.3 36.2,-84.2 36.2,-84.2 36.4,-84.3 36.2))"))
    polygons.dataProvider().addFeature(feature)
    (tmp_path / "area.geojson").write_text(
        '{"type":"Polygon","coordinates":[[[-84.3,36.2],[-84.2,36.2],[-84.2,36.4],[-84.3,36.2]]]}'
    )
    generate(INPUT=raster, CUTLINE=polygons, OUTPUT=str(tmp_path / "a"))
    expected = by_command(
        tmp_path / "b", "--tilesize", "64", "--max-zoom", "8", "--cutline", str(tmp_path / "area.geojson"),
        "--oo", "NUM_THREADS=1",
    )
    assert tree(tmp_path / "a") == expected


def test_errors_are_the_commands_own(qgis, feedback, tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "letter.txt").write_text("mine")
    done = subprocess.run([COMMAND, DEM, tmp_path / "full"], capture_output=True, check=False)
    own = done.stderr.decode().strip().split(": error: ")[1]
    assert raises(own, feedback, OUTPUT=str(tmp_path / "full")) == own
    raises("--max-error abc", OUTPUT=str(tmp_path / "a"), MAX_ERROR="abc")
    (tmp_path / "text.tif").write_text("no raster")
    raises("text.tif", INPUT=str(tmp_path / "text.tif"), OUTPUT=str(tmp_path / "a"))


def test_wrong_input_in_qgis_process(run_process, tmp_path):
    run_process("qmesh:generate", INPUT=tmp_path / "none.tif", OUTPUT=tmp_path / "a").failed("none.tif")
    run_process("qmesh:generate", INPUT=DEM, OUTPUT=tmp_path / "a", MAX_ERROR="abc").failed("--max-error abc")
    run_process("qmesh:generate", INPUT=DEM, OUTPUT=tmp_path / "a", METHOD="magic").failed("METHOD")
    run_process("qmesh:generate", INPUT=DEM, OUTPUT="/proc/none/a").failed("/proc/none")
    assert not (tmp_path / "a").exists()


def test_warnings_of_the_command_are_warnings(qgis, feedback, tmp_path):
    generate(feedback, OUTPUT=str(tmp_path / "a"), MAX_ERROR="0")
    assert any("rounding" in text for text in feedback.warnings), feedback.warnings


def test_cancel_in_the_middle_leaves_nothing(qgis, feedback, tmp_path):
    """Cancelled while tiles are made: the command stops by itself, and what was there stays."""
    by_command(tmp_path / "a", "--tilesize", "64", "--max-zoom", "5")
    before = tree(tmp_path / "a")

    def cancel_when_at_work():
        limit = time.monotonic() + 60
        while time.monotonic() < limit and not (feedback.percents and feedback.percents[-1] >= 2.5):
            time.sleep(0.005)
        feedback.cancel()

    thread = threading.Thread(target=cancel_when_at_work)
    thread.start()
    results = generate(
        feedback, OUTPUT=str(tmp_path / "a"), OVERWRITE=True, TILESIZE="256", MAX_ZOOM=14, METHOD="greedy",
        MAX_ERROR="0.01", NUM_THREADS="1",
    )
    thread.join()
    assert feedback.percents[-1] < 100 and "TILES" not in results
    assert tree(tmp_path / "a") == before
    assert [p.name for p in tmp_path.iterdir()] == ["a"]


def test_command_by_the_setting_only(qgis, setting, tmp_path):
    from qmesh_processing import places

    (tmp_path / "bin").mkdir()
    os.symlink(COMMAND, tmp_path / "bin" / "gdal2qmesh")
    setting(places.COMMANDS_SETTING, str(tmp_path / "bin"))
    assert places.find_command("gdal2qmesh") == str(tmp_path / "bin" / "gdal2qmesh")
    generate(OUTPUT=str(tmp_path / "a"))
    setting(places.COMMANDS_SETTING, str(tmp_path))
    raises("gdal2qmesh was not found in " + str(tmp_path), OUTPUT=str(tmp_path / "b"))


def test_missing_command_in_qgis_process(run_process, tmp_path):
    """PATH without the command; the algorithm is listed all the same, and says what to do."""
    environment = {"PATH": "/usr/bin:/bin"}
    process = run_process("qmesh:generate", environment, INPUT=DEM, OUTPUT=tmp_path / "a")
    process.failed("gdal2qmesh was not found on PATH or beside the plugin", "Settings > Options")


def test_a_model_runs_it(run_process, tmp_path):
    """A model as the designer saves it: DEM and max error are its inputs, the terrain its output."""
    model = write_model(tmp_path / "terrain.model3")
    results = run_process(model, dem=DEM, error="5", **{"generate:terrain": tmp_path / "a"}).succeeded()
    assert results["generate:terrain"] == str(tmp_path / "a")
    assert tree(tmp_path / "a") == by_command(
        tmp_path / "b", "--tilesize", "64", "--max-zoom", "8", "--max-error", "5"
    )


def write_model(path):
    """Written in a process of its own, because this one may not have QGIS yet."""
    subprocess.run([sys.executable, HERE / "write_model.py", path], check=True, timeout=120)
    return path
