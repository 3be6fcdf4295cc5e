# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What the command says: help, progress, counts, reports; and the page it writes."""

import json

import numpy as np
import pytest

import harness
import promises
from oracle import tin
from oracle.scheme import node_u
from oracle.tileset import TileSet
from test_options import build, terrain_files

def test_a_configuration_file_says_the_same(tmp_path, dem):
    (tmp_path / "set.conf").write_text(
        "# the terrain of the tests\nmax-error = 20\nnormals = off\nzoom = 0-9\n\ncopyright = me\n")
    build(dem("small"), tmp_path / "a", "--config-file", tmp_path / "set.conf")
    build(dem("small"), tmp_path / "b", "--max-error", "20", "--no-normals", "-z", "0-9", "-c", "me")
    assert harness.tree(tmp_path / "a") == harness.tree(tmp_path / "b")
    build(dem("small"), tmp_path / "c", "--config-file", tmp_path / "set.conf", "-z", "0-4")
    assert max(TileSet(tmp_path / "c").levels()) == 4, "the command line wins"
    (tmp_path / "bad.conf").write_text("max-error = 20\nno-such = 1\n")
    harness.gdal2qmesh("--config-file", tmp_path / "bad.conf", dem("small"), tmp_path / "d").failed(
        harness.USAGE, "bad.conf", "2", "no-such")


def tile_counts(text):
    """zoom -> tiles from lines that begin with a zoom number."""
    counts = {}
    for line in text.splitlines():
        words = line.replace(":", " ").split()
        numbers = [w for w in words if w.isdigit()]
        if numbers and (words[0].isdigit() or words[0].lower() in ("zoom", "z")):
            if len(numbers) > 1:
                counts[int(numbers[0])] = int(numbers[1])
    return counts


@pytest.mark.parametrize("name", ["jacksboro", "global", "void", "antimeridian_utm"])
def test_a_dry_run_counts_and_writes_nothing(tmp_path, dem, tile_set, name):
    run = harness.gdal2qmesh("--dry-run", dem(name), "out", cwd=tmp_path).succeeded()
    assert list(tmp_path.iterdir()) == []
    levels = tile_set(name, "-q", "-p", "geodetic").levels()
    assert tile_counts(run.out) == {z: len(level) for z, level in levels.items()}


def test_the_report_counts_what_is_there(tmp_path, dem):
    report = tmp_path / "report.json"
    tiles = build(dem("jacksboro"), tmp_path / "a", "--report", report)
    said = json.loads(report.read_text())
    nodes = promises.nodes_of(dem("jacksboro"), "geodetic", 256, max(tiles.levels()))
    assert [level["zoom"] for level in said["zooms"]] == sorted(tiles.levels())
    u = node_u(256)
    for level in said["zooms"]:
        z = level["zoom"]
        names = tiles.levels()[z]
        assert level["tiles"] == len(names)
        assert level["vertices"] == sum(len(tiles.tile(*t).u) for t in names)
        assert level["triangles"] == sum(len(tiles.tile(*t).triangles) for t in names)
        assert level["bytes"] == sum(tiles.path(*t).stat().st_size for t in names)
        errors = np.stack([tin.evaluate(tiles.tile(*t), u, tiles.scheme.node_v(z, t[2], 256))
                           - nodes.tile(*t)[0] for t in names])
        assert level["errorReached"] == pytest.approx(np.abs(errors).max(), abs=2e-3)
        assert level["rmsError"] == pytest.approx(np.sqrt((errors**2).mean()), rel=1e-2, abs=2e-3)
    assert said["total"]["tiles"] == len(tiles.available())
    assert {"wall", "sample", "reduce", "mesh", "encode", "write"} <= set(said["seconds"])


def test_options_json_is_json_and_complete():
    said = json.loads(harness.gdal2qmesh("--options-json").succeeded().out)
    text = json.dumps(said)
    for name in ("max-error", "screen-error", "zoom", "tilesize", "void-fill", "metadata", "memory"):
        assert f'"{name}"' in text


def test_help_and_version():
    run = harness.gdal2qmesh("--help").succeeded()
    assert run.out.lower().startswith("usage: gdal2qmesh") and not run.err
    for word in ("--max-error", "--screen-error", "--zoom", "--overwrite", "greedy", "delaunay"):
        assert word in run.out
    assert max(map(len, run.out.splitlines())) <= 80
    brief = harness.gdal2qmesh("-h").succeeded().out
    assert len(brief) < len(run.out) / 3 and "--max-error" in brief and "--help" in brief
    assert harness.gdal2qmesh("--version").succeeded().out.strip()


def test_quiet_says_nothing_and_usual_says_progress(tmp_path, dem):
    run = harness.gdal2qmesh("-q", dem("small"), tmp_path / "a").succeeded()
    assert run.out == "" and run.err == ""
    run = harness.gdal2qmesh(dem("small"), tmp_path / "b").succeeded()
    assert "0...10...20...30...40...50...60...70...80...90...100 - done." in run.out
    assert "\r" not in run.out, "no terminal, so nothing is rewritten"


def test_gdal2tiles_options_without_meaning_only_warn(tmp_path, dem):
    build(dem("small"), tmp_path / "a")
    run = harness.gdal2qmesh("-k", "-n", "-g", "key", "-d", dem("small"), tmp_path / "b").succeeded()
    assert run.err.lower().count("warning") == 3
    assert terrain_files(tmp_path / "a") == terrain_files(tmp_path / "b")


def test_long_options_take_their_value_either_way(tmp_path, dem):
    build(dem("small"), tmp_path / "a", "--max-error=30", "--processes=1")
    build(dem("small"), tmp_path / "b", "--max-error", "30", "--num-threads", "2")
    assert harness.tree(tmp_path / "a") == harness.tree(tmp_path / "b")


@pytest.mark.parametrize("viewer", ["cesium", "all"])
def test_the_preview_page(tmp_path, dem, viewer):
    harness.gdal2qmesh("-q", "-w", viewer, "-t", "Small <hills>", dem("small"),
                       tmp_path / "a").succeeded()
    page = (tmp_path / "a" / "index.html").read_text()
    assert "Small &lt;hills&gt;" in page and "Small <hills>" not in page
    assert "cesium.com/downloads/cesiumjs/releases/1." in page
    assert "@" not in page.replace("@media", ""), "a placeholder was not filled"
    harness.gdal2qmesh("-q", "-w", "none", dem("small"), tmp_path / "b").succeeded()
    assert not (tmp_path / "b" / "index.html").exists()


def test_a_cesium_of_ones_own_is_copied(tmp_path, dem):
    own = tmp_path / "cesium"
    (own / "Workers").mkdir(parents=True)
    (own / "Widgets").mkdir()
    (own / "Cesium.js").write_text("// Cesium")
    (own / "Widgets" / "widgets.css").write_text("/* css */")
    (own / "Workers" / "a.js").write_text("// worker")
    harness.gdal2qmesh("-q", "-w", "cesium", "--cesium", own, dem("small"),
                       tmp_path / "a").succeeded()
    copies = list((tmp_path / "a").rglob("Cesium.js"))
    assert len(copies) == 1 and (copies[0].parent / "Workers" / "a.js").exists()
    page = (tmp_path / "a" / "index.html").read_text()
    assert "https://cesium.com/downloads" not in page


def test_nothing_hidden_is_left(tmp_path, dem):
    harness.gdal2qmesh("-q", "-w", "cesium", dem("small"), tmp_path / "a").succeeded()
    assert harness.hidden_files(tmp_path / "a") == []
    harness.gdal2qmesh("-q", "--overwrite", dem("small"), tmp_path / "a").succeeded()
    assert harness.hidden_files(tmp_path / "a") == []
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a"]
