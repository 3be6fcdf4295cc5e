# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Fixtures of the outside tests: the command as a real process on real files.

QMESH_BIN        the command (default build/bin/gdal2qmesh of this tree)
QMESH_TEST_DATA  folder with the real DEMs (default ../shared/data beside this tree; without it the
                 tests that need them are skipped, and that is said)
QMESH_FULL       1: the large DEMs uncut
"""

import pathlib
import sys

import pytest

_HERE = pathlib.Path(__file__).resolve().parent
for folder in (_HERE, _HERE.parent, _HERE.parent / "tools"):
    sys.path.insert(0, str(folder))

import harness  # noqa: E402
from oracle.tileset import TileSet  # noqa: E402
from sessions import shared_dems, shared_sets  # noqa: E402

_skipped_data = []


def pytest_configure():
    if not harness.BIN.exists():
        pytest.exit(f"there is no {harness.BIN}: build it, or say with QMESH_BIN where it is", 4)


@pytest.fixture(scope="session")
def dem(tmp_path_factory):
    """A function name -> path of that DEM, made once; skips where a real DEM is not there."""
    return shared_dems(tmp_path_factory.mktemp("dems"), _skipped_data)


@pytest.fixture(scope="session")
def tile_set(tmp_path_factory, dem):
    """A function (DEM name, options...) -> TileSet, built once per session."""
    return shared_sets(tmp_path_factory.mktemp("sets"), dem, TileSet)


def pytest_terminal_summary(terminalreporter):
    if _skipped_data:
        terminalreporter.write_line(
            "Real DEMs not found in " + str(harness.DATA) + ": " + ", ".join(sorted(set(_skipped_data)))
        )
