# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Fixtures of the driver's tests: osgeo.gdal with the plugin of this build.

QMESH_BIN        the command to compare with (default build/bin/gdal2qmesh of this tree)
QMESH_PLUGINS    the folder of gdal_QMESH.so (default gdalplugins beside the command's folder)
QMESH_TEST_DATA, QMESH_FULL: as in autotest/utils
"""

import os
import pathlib
import re
import sys

import pytest

_HERE = pathlib.Path(__file__).resolve().parent
for folder in (_HERE, _HERE.parent, _HERE.parent / "tools", _HERE.parent / "utils"):
    sys.path.insert(0, str(folder))

import harness  # noqa: E402

PLUGINS = pathlib.Path(os.environ.get("QMESH_PLUGINS", harness.BIN.parent.parent / "gdalplugins"))
# Before osgeo.gdal is imported: that registers all drivers, and programs started by a test inherit it.
os.environ["GDAL_DRIVER_PATH"] = str(PLUGINS)

from osgeo import gdal  # noqa: E402

import sessions  # noqa: E402

gdal.UseExceptions()
_skipped_data = []


def pytest_configure():
    if not harness.BIN.exists():
        pytest.exit(f"there is no {harness.BIN}: build it, or say with QMESH_BIN where it is", 4)
    if gdal.GetDriverByName("QMESH") is None:
        pytest.exit(f"GDAL finds no driver QMESH in {PLUGINS}: build gdal_QMESH", 4)


@pytest.fixture(scope="session")
def qmesh():
    """The driver."""
    return gdal.GetDriverByName("QMESH")


@pytest.fixture(scope="session")
def dem(tmp_path_factory):
    """A function name -> path of that DEM, made once; skips where a real DEM is not there."""
    return sessions.shared_dems(tmp_path_factory.mktemp("dems"), _skipped_data)


@pytest.fixture(scope="session")
def command_set(tmp_path_factory, dem):
    """A function (DEM name, options of gdal2qmesh...) -> folder, built once per session."""
    return sessions.shared_sets(tmp_path_factory.mktemp("sets"), dem, pathlib.Path)


@pytest.fixture
def vsimem(request):
    """A folder in /vsimem/, removed after the test."""
    folder = "/vsimem/" + re.sub(r"[^A-Za-z0-9]+", "-", request.node.name)
    gdal.Mkdir(folder, 0o755)
    yield folder
    gdal.RmdirRecursive(folder)


def pytest_terminal_summary(terminalreporter):
    if _skipped_data:
        terminalreporter.write_line(
            "Real DEMs not found in " + str(harness.DATA) + ": " + ", ".join(sorted(set(_skipped_data)))
        )
