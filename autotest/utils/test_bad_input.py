# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""P8: bad input is an answer: one clear line, the right exit code, and nothing lost."""

import contextlib
import os
import resource
import signal
import subprocess

import numpy as np
import pytest
from osgeo import gdal

import dems
import harness
from harness import DONE, INPUT, OUTPUT, USAGE


def run(*args, **kinds):
    return harness.gdal2qmesh("-q", *args, **kinds)


@contextlib.contextmanager
def unchanged(folder):
    """Whatever runs inside must leave the folder as it is."""
    before = harness.tree(folder)
    yield
    assert harness.tree(folder) == before


# ---- inputs that cannot be used ----


def bad_inputs(folder):
    """name -> (path, words the message must hold)"""
    ground = dems.hills(20, 20)
    (folder / "text.tif").write_text("this is not a raster")
    (folder / "empty.tif").write_bytes(b"")
    (folder / "folder").mkdir()
    void = np.full((20, 20), -9999, np.float32)
    cut = (folder / "whole.tif")
    dems.write(cut, dems.hills(400, 400))
    (folder / "cut.tif").write_bytes(cut.read_bytes()[: cut.stat().st_size // 2])
    zero = gdal.GetDriverByName("VRT").Create(str(folder / "zero.vrt"), 20, 20, 0)
    zero.SetGeoTransform((10, 0.001, 0, 47, 0, -0.001))
    zero.SetProjection(gdal.Open(str(harness.SHIPPED)).GetProjection())
    del zero
    return {
        "missing file": (folder / "missing.tif", ["missing.tif"]),
        "text": (folder / "text.tif", ["text.tif"]),
        "empty file": (folder / "empty.tif", ["empty.tif"]),
        "folder": (folder / "folder", ["folder"]),
        "cut short": (folder / "cut.tif", ["cut.tif"]),
        "zero bands": (folder / "zero.vrt", ["zero.vrt", "band"]),
        "no georeferencing": (
            dems.write(folder / "nogeo.tif", ground, None, None), ["nogeo.tif", "georef"]),
        "no CRS": (dems.write(folder / "nocrs.tif", ground, srs=None), ["nocrs.tif", "-s"]),
        "local CRS": (
            dems.write(folder / "local.tif", ground, srs='LOCAL_CS["site",UNIT["metre",1]]'),
            ["local.tif"]),
        "singular geotransform": (
            dems.write(folder / "singular.tif", ground, (10, 0.001, 0.001, 47, 0.001, 0.001)),
            ["singular.tif"]),
        "complex": (
            dems.write(folder / "complex.tif", ground.astype(np.complex64)),
            ["complex.tif", "complex"]),
        "all nodata": (
            dems.write(folder / "void.tif", void, nodata=-9999), ["void.tif"]),
        "all NaN": (
            dems.write(folder / "nan.tif", np.full((20, 20), np.nan, np.float32)), ["nan.tif"]),
        "all infinite": (
            dems.write(folder / "inf.tif", np.full((20, 20), np.inf, np.float32)), ["inf.tif"]),
    }


BAD = ["missing file", "text", "empty file", "folder", "cut short", "zero bands",
       "no georeferencing", "no CRS", "local CRS", "singular geotransform", "complex", "all nodata",
       "all NaN", "all infinite"]


@pytest.mark.parametrize("name", BAD)
def test_an_input_that_cannot_be_used(tmp_path, name):
    path, words = bad_inputs(tmp_path)[name]
    with unchanged(tmp_path):
        run(path, tmp_path / "out").failed(INPUT, *words)


@pytest.mark.parametrize("name", ["cut short", "all nodata", "no CRS"])
def test_a_failed_run_loses_nothing(tmp_path, name):
    """With --overwrite and a finished set in the place: it is still there, whole."""
    path, _ = bad_inputs(tmp_path)[name]
    good = dems.write(tmp_path / "good.tif", dems.hills(30, 30))
    run(good, tmp_path / "out").succeeded()
    (tmp_path / "out" / "notes.txt").write_text("mine")
    (tmp_path / "out" / "0" / "0" / "mine.txt").write_text("mine too")
    with unchanged(tmp_path):
        run("--overwrite", path, tmp_path / "out").failed(INPUT)


def test_source_srs_cures_a_missing_one(tmp_path):
    ground = dems.hills(30, 30)
    bare = dems.write(tmp_path / "bare.tif", ground, srs=None)
    full = dems.write(tmp_path / "full.tif", ground)
    run("-s", "EPSG:4326", bare, tmp_path / "bare").succeeded()
    run(full, tmp_path / "full").succeeded()
    got, expected = harness.tree(tmp_path / "bare"), harness.tree(tmp_path / "full")
    got.pop("layer.json"), expected.pop("layer.json")  # it holds the input's name
    assert got == expected
    run("-s", "EPSG:999999", bare, tmp_path / "none").failed(USAGE, "999999")


def test_a_system_alone_does_not_place_a_raster(tmp_path):
    path = dems.write(tmp_path / "nogeo.tif", dems.hills(20, 20), None, None)
    with unchanged(tmp_path):
        run("-s", "EPSG:4326", path, tmp_path / "out").failed(INPUT, "nogeo.tif", "georef")


def test_band_and_cutline_that_are_not_there(tmp_path):
    good = dems.write(tmp_path / "good.tif", dems.hills(30, 30))
    with unchanged(tmp_path):
        run("-b", "2", good, tmp_path / "out").failed(INPUT, "band", "2")
        run("--cutline", tmp_path / "no.geojson", good, tmp_path / "out").failed(INPUT, "no.geojson")
        run("--if", "PNG", good, tmp_path / "out").failed(INPUT, "good.tif")
        run("--if", "GTif", good, tmp_path / "out").failed(USAGE, "GTif", "--formats")
        run("--te", "50", "50", "51", "51", good, tmp_path / "out").failed(INPUT)
    lines = {"type": "FeatureCollection", "features": []}
    (tmp_path / "empty.geojson").write_text(str(lines).replace("'", '"'))
    with unchanged(tmp_path):
        run("--cutline", tmp_path / "empty.geojson", good, tmp_path / "out").failed(INPUT)


# ---- usage ----

USAGE_ERRORS = [
    (["--no-such-option"], "no-such-option"),
    (["--max-eror", "3"], "max-error"),  # a hint
    (["-z", "3-2"], "3-2"),
    (["-z", "a"], "a"),
    (["-z", "0-25"], "24"),
    (["-z", "-1"], "-1"),
    (["--max-zoom", "25"], "24"),
    (["--min-zoom", "6", "--max-zoom", "5"], "zoom"),
    (["-p", "raster"], "raster"),
    (["-p", "lunar"], "lunar"),
    (["--tilesize", "100"], "100"),
    (["--tilesize", "4"], "8"),
    (["--tilesize", "2048"], "1024"),
    (["--method", "magic"], "magic"),
    (["-r", "magic"], "magic"),
    (["-w", "leaflet"], "leaflet"),
    (["--compress", "zip"], "zip"),
    (["--max-error", "abc"], "abc"),
    (["--max-error", "1,,2"], "1,,2"),
    (["--max-error", "5/3^z"], "5/3^z"),
    (["--max-error", "0-3:5,2:1"], "0-3:5,2:1"),
    (["--max-error", "-1"], "-1"),
    (["--max-error", "nan"], "nan"),
    (["--max-error", "3-4:1"], "zoom"),  # leaves zooms out
    (["--screen-error", "x"], "x"),
    (["--memory", "1MB"], "memory"),
    (["--memory", "lots"], "lots"),
    (["-j", "0x"], "0x"),
    (["-a", "high"], "high"),
    (["-b", "0"], "0"),
    (["--te", "1", "2", "3"], "te"),
    (["--te", "3", "2", "1", "4"], "te"),
    (["--clip-low", "10", "--clip-high", "5"], "clip"),
    (["--void-fill", "deep"], "deep"),
    (["--metadata", "-3"], "-3"),
    (["--block-tiles", "3"], "3"),
    (["--config-file", "not-there.conf"], "not-there.conf"),
    (["--cesium", "not-a-folder", "-w", "cesium"], "not-a-folder"),
]


@pytest.mark.parametrize("options, word", USAGE_ERRORS, ids=[" ".join(o) for o, _ in USAGE_ERRORS])
def test_a_usage_error(tmp_path, options, word):
    good = dems.write(tmp_path / "good.tif", dems.hills(30, 30))
    with unchanged(tmp_path):
        failed = run(*options, good, tmp_path / "out").failed(USAGE, word)
    assert failed.err.lstrip().lower().startswith("usage: gdal2qmesh")


def test_no_input_and_too_many_arguments(tmp_path):
    run().failed(USAGE, "input")
    run("a.tif", "b", "c").failed(USAGE, "c")


# ---- outputs ----


@pytest.fixture
def good(tmp_path):
    return dems.write(tmp_path / "good.tif", dems.hills(200, 200))


def test_an_open_option_that_the_driver_does_not_know(tmp_path, good):
    done = harness.gdal2qmesh("--oo", "NUM_THREAD=1", good, tmp_path / "out").succeeded()
    assert "gdal2qmesh: warning: --oo NUM_THREAD=1: " in done.err
    done = harness.gdal2qmesh("--oo", "NUM_THREADS=1", good, tmp_path / "out2").succeeded()
    assert "warning" not in done.err


def test_an_output_that_holds_something_is_refused(tmp_path, good):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "notes.txt").write_text("mine")
    with unchanged(tmp_path):
        run(good, tmp_path / "out").failed(OUTPUT, "out", "--overwrite")


def test_an_empty_folder_is_taken(tmp_path, good):
    (tmp_path / "out").mkdir()
    run(good, tmp_path / "out").succeeded()


def test_overwrite_replaces_the_set_and_keeps_foreign_files(tmp_path, good):
    out = tmp_path / "out"
    run(good, out).succeeded()
    deepest = max(int(p.name) for p in out.iterdir() if p.name.isdigit())
    foreign = {"notes.txt": "mine", "0/0/notes.txt": "also mine", f"{deepest}/photo.jpg": "x",
               "pictures/a.terrain.txt": "y"}
    for name, text in foreign.items():
        (out / name).parent.mkdir(exist_ok=True)
        (out / name).write_text(text)
    run("--overwrite", "-z", "0-5", good, out).succeeded()
    run("-z", "0-5", good, tmp_path / "fresh").succeeded()
    files = {k: v for k, v in harness.tree(out).items() if v}
    fresh = {k: v for k, v in harness.tree(tmp_path / "fresh").items() if v}
    assert {k: v for k, v in files.items() if k not in foreign} == fresh
    assert {k: (out / k).read_text() for k in foreign} == foreign


def test_an_output_that_is_a_file_or_inside_one(tmp_path, good):
    (tmp_path / "file").write_text("mine")
    with unchanged(tmp_path):
        run(good, tmp_path / "file").failed(OUTPUT, "file")
        run("--overwrite", good, tmp_path / "file").failed(OUTPUT, "file")
        run(good, tmp_path / "file" / "out").failed(OUTPUT, "file")
        run(good, good).failed(OUTPUT)


def test_an_output_where_nobody_may_write(good):
    run(good, "/proc/qmesh-test").failed(OUTPUT, "/proc/qmesh-test")


def test_a_folder_without_permission(tmp_path):
    """Run as nobody where the tests run as root, who may write everywhere."""
    open_folder = subprocess.run(["mktemp", "-d"], capture_output=True, text=True, check=True)
    base = open_folder.stdout.strip()
    os.chmod(base, 0o755)
    good = dems.write(f"{base}/good.tif", dems.hills(30, 30))
    os.mkdir(f"{base}/closed", 0o555)
    os.chmod(good, 0o644)
    nobody = (lambda: os.setuid(65534)) if os.getuid() == 0 else None
    if nobody and subprocess.run([str(harness.BIN), "--version"], preexec_fn=nobody,
                                 capture_output=True, check=False).returncode != DONE:
        pytest.skip("nobody may not run the command from where it was built")
    try:
        with unchanged(base):
            run(good, f"{base}/closed/out", preexec=nobody).failed(OUTPUT, "closed")
            run(good, f"{base}/closed", preexec=nobody).failed(OUTPUT, "closed")
    finally:
        subprocess.run(["rm", "-r", base], check=True)


def small_files():
    resource.setrlimit(resource.RLIMIT_FSIZE, (6000, 6000))
    signal.signal(signal.SIGXFSZ, signal.SIG_DFL)


def test_a_file_size_limit_is_a_full_disk(tmp_path, good):
    """The command must ignore SIGXFSZ itself, and the set that was there stays."""
    with unchanged(tmp_path):
        run("--compress", "none", good, tmp_path / "out", preexec=small_files).failed(OUTPUT)
    run("-z", "0-3", good, tmp_path / "out").succeeded()
    with unchanged(tmp_path):
        run("--overwrite", "--compress", "none", good, tmp_path / "out",
            preexec=small_files).failed(OUTPUT)


def test_a_full_disk(tmp_path, good):
    disk = tmp_path / "disk"
    disk.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", str(disk)],
                             capture_output=True, text=True, check=False)
    if mounted.returncode:
        pytest.skip(f"no tmpfs may be mounted here: {mounted.stderr.strip()}")
    try:
        (disk / "notes.txt").write_text("mine")
        with unchanged(disk):
            run("--method", "delaunay", good, disk / "out").failed(OUTPUT)
        run("-z", "0-2", "--max-error", "1000", good, disk / "out").succeeded()
        with unchanged(disk):
            run("--method", "delaunay", "--overwrite", good, disk / "out").failed(OUTPUT)
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def test_a_report_that_cannot_be_written(tmp_path, good):
    with unchanged(tmp_path):
        run("--report", tmp_path / "no" / "report.json", good, tmp_path / "out").failed(
            OUTPUT, "report.json")
