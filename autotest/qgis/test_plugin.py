# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The plugin as QGIS's plugin manager gets it, and its dialogs as people see them."""

import configparser
import os
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
import zipfile

import pytest
from conftest import BUILD, PLUGINS, qgis_process

HERE = pathlib.Path(__file__).resolve().parent
ZIP = BUILD / "qmesh-qgis.zip"
ALGORITHMS = ["generate", "info", "triangles", "measure", "preview"]


def test_metadata_is_complete():
    parser = configparser.ConfigParser(interpolation=None)
    parser.read(PLUGINS / "qmesh_processing" / "metadata.txt", encoding="utf-8")
    general = parser["general"]
    for key in ("name", "description", "about", "version", "author", "email", "tags", "icon", "homepage", "tracker",
                "repository", "license", "category", "changelog"):
        assert general[key].strip(), key
    assert general["qgisMinimumVersion"] == "3.22" and general["hasProcessingProvider"] == "yes"
    assert "@" not in general["version"]
    icon = xml.parse(PLUGINS / "qmesh_processing" / general["icon"]).getroot()
    assert icon.tag.endswith("svg")


def test_the_zip_holds_one_folder_and_all_files():
    names = zipfile.ZipFile(ZIP).namelist()
    assert {name.split("/")[0] for name in names} == {"qmesh_processing"}
    here = [p for p in PLUGINS.rglob("*") if p.is_file() and "__pycache__" not in p.parts]
    assert sorted(names) == sorted(p.relative_to(PLUGINS).as_posix() for p in here)
    assert "qmesh_processing/LICENSE" in names


def test_the_zip_works_where_it_is_unpacked(tmp_path):
    """With a home of its own, the command beside the plugin, nothing on PATH."""
    zipfile.ZipFile(ZIP).extractall(tmp_path / "plugins")
    (tmp_path / "plugins" / "qmesh_processing" / "bin").mkdir()
    os.symlink(BUILD / "bin" / "gdal2qmesh", tmp_path / "plugins" / "qmesh_processing" / "bin" / "gdal2qmesh")
    environment = {"HOME": str(tmp_path), "QGIS_PLUGINPATH": str(tmp_path / "plugins"), "PATH": "/usr/bin:/bin"}
    qgis_process("plugins", "enable", "qmesh_processing", environment=environment).succeeded()
    listed = qgis_process("list", environment=environment).text
    for name in ALGORITHMS:
        assert f"qmesh:{name}\t" in listed
    shown = qgis_process("help", "qmesh:generate", environment=environment).text
    assert "MAX_ERROR: Max error [m]" in shown


def test_every_option_of_the_command_has_a_parameter_or_a_reason(qgis):
    from qgis.core import QgsApplication
    from qmesh_processing import command, rows

    algorithm = QgsApplication.processingRegistry().algorithmById("qmesh:generate")
    described = command.options_json("gdal2qmesh")
    for row in described["options"]:
        reason = (
            row["name"] in rows.LEFT_OUT or row.get("commandLineOnly") or row.get("ignored")
            or row["name"] == "tmscompatible"  # always on
        )
        parameter = algorithm.parameterDefinition(rows.parameter_name(row))
        assert (parameter is None) == bool(reason), row["name"]
        if parameter is not None:
            assert parameter.help(), row["name"]
            assert bool(parameter.flags() & parameter.FlagAdvanced) == rows.is_advanced(row)


@pytest.mark.parametrize("size", [1, 2, 3, 7, 1000])
def test_output_in_pieces_of_any_size(qgis, size):
    from qmesh_processing.progress import LINE, LineReader

    percents, warnings, others = [], [], []
    reader = LineReader(percents.append, warnings.append, others.append)
    text = f"a -> b\n{LINE} - done.\nusage: x\nx: warning: café\n100 tiles\n0 errors\nx: error: no\nlast".encode()
    for k in range(0, len(text), size):
        reader.feed(text[k : k + size])
    reader.finish()
    assert percents == sorted(percents) and percents[-1] == 100 and len(set(percents)) == len(percents)
    if size == 1:
        assert percents == [2.5 * k for k in range(1, 41)]
    assert warnings == ["café"] and reader.errors == ["no"]
    assert others == ["a -> b", "100 tiles", "0 errors", "last"]


@pytest.mark.parametrize("name", ALGORITHMS)
def test_dialog(tmp_path, name):
    """Under a virtual screen, as a picture; keep it with QMESH_SCREENSHOTS=FOLDER to look at it."""
    picture = tmp_path / f"{name}.png"
    run = subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 1280x1280x24", sys.executable, HERE / "show_dialog.py", f"qmesh:{name}", picture],
        capture_output=True, timeout=120, check=False,
    )
    assert run.returncode == 0, run.stdout.decode() + run.stderr.decode()
    counted = subprocess.run(["identify", "-format", "%w %k", picture], capture_output=True, check=True).stdout
    width, colours = map(int, counted.split())
    assert width == 960 and colours > 50, "a dialog has text, fields and buttons"
    kept = os.environ.get("QMESH_SCREENSHOTS")
    if kept:
        shutil.copy(picture, kept)
