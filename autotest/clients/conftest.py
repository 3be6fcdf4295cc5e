# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Fixtures of the client tests: sets made by the command, Node programs that load them.

QMESH_BIN, QMESH_TEST_DATA as in autotest/utils. QMESH_NODE: the Node program (default node, then nodejs).
QMESH_SCREENSHOTS: a folder to keep the pictures of the preview page in.
"""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
for folder in (HERE, HERE.parent / "utils", HERE.parent / "tools"):
    sys.path.insert(0, str(folder))

from sessions import shared_dems, shared_sets  # noqa: E402


@pytest.fixture(scope="session")
def node():
    """A function (script, arguments...) -> finished process of Node, its words in stdout."""
    program = os.environ.get("QMESH_NODE") or shutil.which("node") or shutil.which("nodejs")
    assert program, "no Node: install nodejs or set QMESH_NODE"
    assert (HERE / "node_modules" / "cesium").exists(), \
        "the Node packages are not installed: npm install --no-package-lock in autotest/clients"

    def run(script, *arguments):
        return subprocess.run([program, HERE / script, *map(str, arguments)], text=True, timeout=900,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, check=False)

    return run


@pytest.fixture(scope="session")
def dem(tmp_path_factory):
    """A function name -> path of that DEM, made once; skips where a real DEM is not there."""
    return shared_dems(tmp_path_factory.mktemp("dems"))


@pytest.fixture(scope="session")
def tile_set(tmp_path_factory, dem):
    """A function (DEM name, options...) -> folder of the set, built once."""
    return shared_sets(tmp_path_factory.mktemp("sets"), dem, pathlib.Path)
