# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Every command line of the README and of docs/ (blocks marked `sh`) is run, each in a folder of its own with the files
that the pages talk about: the DEM dem.tif and its kin, and a finished set `terrain` where the line does not make it."""

import os
import re
import shlex
import shutil
import signal
import subprocess
import time
import urllib.request

import harness
import numpy as np
import pytest
from conftest import ROOT, blocks, pages
from osgeo import gdal, ogr, osr

# Lines that other tests run, and which.
ELSEWHERE = {
    "utils/quickstart.sh": "autotest/docs/test_quickstart.py",
    "autotest/run.sh": "this run itself",
    "autotest/run.sh --quick": "this run itself, in part",
    "autotest/run.sh --full": "by hand before a release",
    "python3 -m pytest -q autotest/lint": "autotest/run.sh, stage `lint`",
}
ELSEWHERE_BEGINNINGS = {
    "cmake ": "autotest/run.sh builds with the presets, autotest/install installs",
    "python3 autotest/lint/same_trees.py ": "by hand for a change that keeps the output",
    "python3 autotest/bench/": "autotest/utils/test_bench.py; the long ones by hand for docs/benchmarks.md",
    "valgrind --tool=callgrind build/bin/": "by hand for docs/benchmarks.md",
    "callgrind_annotate": "by hand for docs/benchmarks.md",
    "build/bin/bench_": "autotest/run.sh, stage `benchmark programs`",
    "qgis_process": "autotest/qgis",
    "export PKG_CONFIG_PATH=": "autotest/install",
    "c++ -std=c++17 my_program.cpp": "autotest/install",
}


def _lines():
    for page in pages():
        for block in blocks(page, "sh"):
            for line in block.replace("\\\n", " ").splitlines():
                command = re.sub(r"\s+#\s.*$", "", line).strip()
                if command and not command.startswith("#"):
                    yield str(page.relative_to(ROOT)), command


LINES = sorted(set(_lines()))
ELSEWHERE_USED = [command for _, command in LINES]


def _runs_elsewhere(command):
    return command in ELSEWHERE or any(command.startswith(b) for b in ELSEWHERE_BEGINNINGS)


HERE = [line for line in LINES if not _runs_elsewhere(line[1])]


def _crop(path, **options):
    gdal.Translate(str(path), str(harness.SHIPPED), srcWin=[40, 40, 60, 50], **options)


@pytest.fixture(scope="session")
def files(tmp_path_factory):
    """The files the pages talk about."""
    folder = tmp_path_factory.mktemp("files")
    _crop(folder / "dem.tif")
    _crop(folder / "big.tif")
    gdal.BuildVRT(str(folder / "dem.vrt"), [str(folder / "dem.tif")]).FlushCache()
    gdal.BuildVRT(str(folder / "big.vrt"), [str(folder / "dem.tif")]).FlushCache()
    # metres of UTM, no coordinate system in the file, one void
    values = np.round(gdal.Open(str(folder / "dem.tif")).ReadAsArray()).astype(int)
    values[3, 4] = -9999
    rows = "\n".join(" ".join(map(str, row)) for row in values)
    (folder / "dem.asc").write_text(
        f"ncols {values.shape[1]}\nnrows {values.shape[0]}\nxllcorner 500000\nyllcorner 5000000\ncellsize 90\n{rows}\n"
    )
    _crop(folder / "depths.tif")
    box = gdal.Info(str(folder / "dem.tif"), format="json")["wgs84Extent"]["coordinates"][0]
    _cutline(folder / "country.gpkg", box)
    harness.gdal2qmesh("-q", "-w", "cesium", folder / "dem.tif", folder / "terrain").succeeded()
    return folder


def _cutline(path, ring):
    wgs84 = osr.SpatialReference()
    wgs84.ImportFromEPSG(4326)
    wgs84.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    data = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = data.CreateLayer("country", wgs84, ogr.wkbPolygon)
    feature = ogr.Feature(layer.GetLayerDefn())
    corners = ", ".join(f"{x} {y}" for x, y in ring)
    feature.SetGeometry(ogr.CreateGeometryFromWkt(f"POLYGON (({corners}))"))
    layer.CreateFeature(feature)


def _environment():
    built = ROOT / "build"
    return {
        **os.environ,
        "PATH": f"{harness.BIN.parent}:{os.environ['PATH']}",
        "GDAL_DRIVER_PATH": str(built / "gdalplugins"),
    }


def _serve_briefly(words, folder):
    """A server is right when it serves; then it is stopped."""
    words = [w if w != "quickstart-terrain" else "terrain" for w in words]
    words = [w if w != "8000" else "18765" for w in words]
    server = subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        for _ in range(100):
            try:
                page = urllib.request.urlopen("http://127.0.0.1:18765/layer.json", timeout=5)
                assert page.status == 200
                return
            except OSError:
                time.sleep(0.1)
        raise AssertionError("the server does not answer")
    finally:
        server.send_signal(signal.SIGINT)
        server.wait(20)


@pytest.mark.parametrize("page, command", HERE, ids=[f"{p}: {c}" for p, c in HERE])
def test_the_line_works(files, tmp_path, page, command):
    folder = tmp_path / "work"
    shutil.copytree(files, folder)
    words = shlex.split(command)
    if words[0] == "gdal2qmesh" or "QMESH" in words:
        shutil.rmtree(folder / "terrain")
    if "http.server" in words:
        _serve_briefly(words, folder)
        return
    run = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", command],
        cwd=folder, env=_environment(), capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300,
    )
    assert run.returncode == 0, f"{page}: {command}\n{run.stdout}\n{run.stderr}"


def test_lines_run_elsewhere_are_still_there():
    for command in ELSEWHERE:
        assert command in ELSEWHERE_USED, f"no page has the line '{command}' any more"
    for beginning in ELSEWHERE_BEGINNINGS:
        assert any(c.startswith(beginning) for c in ELSEWHERE_USED), f"no page has a line '{beginning}...' any more"
