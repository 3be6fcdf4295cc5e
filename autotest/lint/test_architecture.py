# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The picture and the table of folders in docs/architecture.md are what the sources include."""

import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(root):
    return subprocess.run([sys.executable, ROOT / "docs/make_architecture.py", "--check", root],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)


@pytest.fixture
def copy(tmp_path):
    for folder in ("common", "driver", "utils"):
        shutil.copytree(ROOT / folder, tmp_path / folder, ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "docs/images").mkdir(parents=True)
    for file in ("docs/architecture.md", "docs/images/folders.svg"):
        shutil.copy(ROOT / file, tmp_path / file)
    return tmp_path


def include(root, file, header):
    path = root / file
    path.write_text(path.read_text() + f'#include "{header}"\n')


def test_they_are_up_to_date():
    run = check(ROOT)
    assert run.returncode == 0, run.stdout


def test_a_new_arrow_makes_them_stale(copy):
    assert check(copy).returncode == 0
    include(copy, "common/geo/vec3.h", "base/status.h")
    run = check(copy)
    assert run.returncode == 1
    assert "docs/images/folders.svg differs" in run.stdout and "docs/architecture.md differs" in run.stdout


def test_a_circle_is_named(copy):
    include(copy, "common/base/text.h", "geo/vec3.h")
    include(copy, "common/geo/vec3.h", "base/text.h")
    run = check(copy)
    assert run.returncode != 0
    assert "include each other in a circle: base, " in run.stdout


def test_every_folder_has_a_row(copy):
    (copy / "utils/added").mkdir()
    (copy / "utils/added/added.cpp").write_text('#include "base/text.h"\n')
    run = check(copy)
    assert run.returncode != 0
    assert run.stdout.endswith("to add or to remove: utils/added\n")
