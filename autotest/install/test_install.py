# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Installs into an empty folder and uses what lies there, as people and other projects do.

QMESH_BUILD  the build folder to install from (default build of this tree)
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("QMESH_BUILD", ROOT / "build"))
DEM = ROOT / "data" / "jacksboro_srtm3.tif"
STRANGER = pathlib.Path(__file__).resolve().parent / "stranger"
sys.path.insert(0, str(ROOT / "autotest"))

from oracle import terrain, validity  # noqa: E402
from oracle.scheme import Scheme  # noqa: E402


def run(*command, **options):
    """Runs to a good end; returns what was printed."""
    done = subprocess.run(
        list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        timeout=300, check=False, **options
    )
    text = done.stdout.decode()
    assert done.returncode == 0, f"{command}\n{text}"
    return text


def install(prefix):
    run("cmake", "--install", BUILD, "--prefix", prefix)
    return prefix


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    # The manual pages alone; that the documentation is without fault is shown in autotest/docs.
    trees = tmp_path_factory.mktemp("doctrees")
    run(sys.executable, "-m", "sphinx", "-q", "-b", "man", "-d", trees, ROOT / "docs", BUILD / "docs" / "man")
    return install(tmp_path_factory.mktemp("prefix"))


def library_folder(prefix):
    (library,) = prefix.rglob("libqmesh.a")
    return library.parent


def test_the_commands_run_from_there(prefix, tmp_path):
    run(prefix / "bin" / "gdal2qmesh", "--tilesize", "64", "-z", "0-9", DEM, tmp_path / "set")
    assert "0 errors" in run(prefix / "bin" / "qmeshinfo", "--validate", tmp_path / "set")
    layer = json.loads((tmp_path / "set" / "layer.json").read_text())
    assert layer["maxzoom"] == 9
    assert (tmp_path / "set" / "0" / "0" / "0.terrain").exists()


def test_nothing_points_back_to_the_source_or_build_folder(prefix):
    texts = [p for p in prefix.rglob("*") if p.suffix in (".cmake", ".pc", ".h", ".py", ".json")]
    assert len(texts) > 60
    for path in texts:
        text = path.read_text()
        assert str(BUILD) not in text and str(ROOT) not in text, path


def test_headers_name_each_other_by_their_installed_place(prefix):
    for header in (prefix / "include" / "qmesh").rglob("*.h"):
        for line in header.read_text().splitlines():
            if line.startswith('#include "'):
                assert (prefix / "include" / line.split('"')[1]).exists(), f"{header}: {line}"


def check_tile(path, said):
    """The tile that stranger/one_tile.cpp writes, by a decoder that shares no code with the library."""
    tile = terrain.decode(terrain.gunzip(path.read_bytes()))
    box = Scheme("geodetic").box(9, 270, 360)
    assert validity.mesh_faults(tile) == []
    assert validity.header_faults(tile, box) == []
    assert int(said.split()[0]) == len(tile.triangles) > 50
    heights = tile.heights()
    corner = np.flatnonzero((tile.u == 0) & (tile.v == 0))[0]
    assert abs(heights[corner] - 250) < 0.5
    assert abs(heights.max() - 340) < 1 and heights.min() > 249
    assert tile.oct_normals() is not None


def test_a_stranger_builds_by_find_package(prefix, tmp_path):
    run("cmake", "-S", STRANGER, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
    run("cmake", "--build", tmp_path / "build")
    said = run(tmp_path / "build" / "one_tile", tmp_path / "hill.terrain")
    check_tile(tmp_path / "hill.terrain", said)


def test_a_stranger_builds_by_pkg_config(prefix, tmp_path):
    environment = {**os.environ, "PKG_CONFIG_PATH": str(library_folder(prefix) / "pkgconfig")}
    flags = run("pkg-config", "--cflags", "--libs", "qmesh", env=environment).split()
    source = shutil.copy(STRANGER / "one_tile.cpp", tmp_path)
    run("c++", "-std=c++17", source, "-o", tmp_path / "one_tile", *flags, cwd=tmp_path)
    said = run(tmp_path / "one_tile", tmp_path / "hill.terrain")
    check_tile(tmp_path / "hill.terrain", said)


def test_every_symbol_of_the_library_is_found(prefix, tmp_path):
    """All of the archive, whatever a program uses of it: no library is missing in what pkg-config says."""
    environment = {**os.environ, "PKG_CONFIG_PATH": str(library_folder(prefix) / "pkgconfig")}
    flags = run("pkg-config", "--cflags", "--libs", "qmesh", env=environment).split()
    at = flags.index("-lqmesh")
    flags[at : at + 1] = ["-Wl,--whole-archive", "-lqmesh", "-Wl,--no-whole-archive"]
    run("c++", "-std=c++17", STRANGER / "one_tile.cpp", "-o", tmp_path / "one_tile", *flags)
    check_tile(tmp_path / "hill.terrain", run(tmp_path / "one_tile", tmp_path / "hill.terrain"))


def test_another_minor_version_is_refused(prefix, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.22)\nproject(newer LANGUAGES CXX)\nfind_package(qmesh 0.99 REQUIRED)\n"
    )
    done = subprocess.run(
        ["cmake", "-S", tmp_path, "-B", tmp_path / "b", f"-DCMAKE_PREFIX_PATH={prefix}"],
        capture_output=True, timeout=120, check=False,
    )
    assert done.returncode != 0 and b"0.1.0" in done.stderr


def complete(prefix, *words, cwd=None):
    """What bash offers for the last of the words."""
    script = prefix / "share" / "bash-completion" / "completions" / words[0]
    text = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _$1 2>/dev/null; printf "%s\\n" "${COMPREPLY[@]}"'
    return run("bash", "-c", text, "bash", script, *words, cwd=cwd).split()


@pytest.mark.parametrize(
    "words, expected",
    [
        (["--max-e"], ["--max-error"]),
        (["--no-n"], ["--no-normals"]),
        (["--proc"], ["--processes"]),
        (["--method", "gr"], ["greedy"]),
        (["--method", "=", "gr"], ["greedy"]),
        (["-p", ""], ["geodetic", "mercator"]),
        (["-r", "cubic"], ["cubic", "cubicspline"]),
        (["--max-error", ""], []),
    ],
)
def test_completion(prefix, words, expected):
    offered = complete(prefix, "gdal2qmesh", *words)
    if words[-1] == "gr":
        assert "greedy" in offered and all(name.startswith("gr") for name in offered)
    else:
        assert offered == expected


def test_completion_of_files_and_folders(prefix, tmp_path):
    (tmp_path / "two words.tif").touch()
    (tmp_path / "folder").mkdir()
    assert complete(prefix, "gdal2qmesh", "t", cwd=tmp_path) == ["two", "words.tif"]
    assert complete(prefix, "gdal2qmesh", "--cesium", "", cwd=tmp_path) == ["folder"]


@pytest.mark.parametrize("command", ["gdal2qmesh", "qmeshinfo"])
def test_completion_knows_every_option(prefix, command):
    rows = json.loads(run(prefix / "bin" / command, "--options-json"))["options"]
    offered = complete(prefix, command, "-")
    for row in rows:
        named = row.get("position") is None and not row.get("ignored")
        assert (f"--{row['name']}" in offered) == named, row["name"]


def test_man_pages_render(prefix):
    pages = sorted(page.stem for page in (prefix / "share" / "man" / "man1").iterdir())
    assert pages == sorted(page.stem for page in (BUILD / "docs" / "man").glob("*.1")) and "gdal2qmesh" in pages
    environment = {**os.environ, "MANPATH": str(prefix / "share" / "man"), "MANPAGER": "cat", "LC_ALL": "C.UTF-8"}
    for page in pages:
        shown = subprocess.run(["man", page], env=environment, capture_output=True, timeout=60, check=True)
        text = shown.stdout.decode()
        assert page in text and "--help" in text and len(text) > 2000


def test_the_driver_is_where_gdal_finds_plugins(prefix, tmp_path):
    (plugin,) = prefix.rglob("gdal_QMESH.so")
    assert plugin.parent.name == "gdalplugins"
    environment = {**os.environ, "GDAL_DRIVER_PATH": str(plugin.parent)}
    run("gdal_translate", "-q", "-of", "QMESH", "-co", "MAX_ZOOM=6", DEM, tmp_path / "set", env=environment)
    assert "QMESH" in run("gdalinfo", tmp_path / "set", env=environment)


def test_the_qgis_plugin_knows_the_programs_of_its_prefix(prefix):
    """PREFIX/share/qgis/python/plugins/qmesh_processing looks in PREFIX/bin."""
    places = prefix / "share" / "qgis" / "python" / "plugins" / "qmesh_processing" / "places.py"
    assert (places.parent / "metadata.txt").exists() and (places.parent / "preview" / "index.html").exists()
    config = "import sys, types; m = types.ModuleType('processing.core.ProcessingConfig'); "
    config += "m.ProcessingConfig = type('C', (), {'getSetting': staticmethod(lambda n: None)}); "
    config += "sys.modules.update({'processing': m, 'processing.core': m, 'processing.core.ProcessingConfig': m}); "
    text = config + f"sys.path.insert(0, {str(places.parent)!r}); import places; print(places.find_command('gdal2qmesh')); "
    text += "print(places.driver_folders()[0])"
    command, driver = run(sys.executable, "-B", "-c", text, env={**os.environ, "PATH": "/usr/bin:/bin"}).split()
    assert command == str(prefix / "bin" / "gdal2qmesh")
    assert (pathlib.Path(driver) / "gdal_QMESH.so").exists() and driver.startswith(str(prefix))


def test_uninstall_leaves_nothing_of_ours(tmp_path):
    prefix = install(tmp_path / "prefix")
    (prefix / "share" / "theirs").mkdir()
    (prefix / "share" / "theirs" / "file").write_text("not ours")
    plugin = prefix / "share" / "qgis" / "python" / "plugins" / "qmesh_processing"
    run(sys.executable, "-m", "compileall", "-q", plugin)
    assert list(plugin.rglob("*.pyc"))
    run("cmake", "--build", BUILD, "--target", "uninstall")
    left = [p.relative_to(prefix).as_posix() for p in prefix.rglob("*")]
    assert sorted(left) == ["share", "share/theirs", "share/theirs/file"]
    again = subprocess.run(
        ["cmake", "--build", BUILD, "--target", "uninstall"], capture_output=True, timeout=120, check=False
    )
    assert again.returncode != 0 and b"Nothing was installed" in again.stdout + again.stderr  # Ninja uses one
