# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Promise P7: CesiumJS in a real browser and loaders.gl load every tile; the preview page shows the set."""

import json
import os
import pathlib
import shutil

import pytest

import harness
from dem_samples import dem_samples
from tiny_set import write_set

CESIUM = pathlib.Path(__file__).resolve().parent / "node_modules" / "cesium" / "Build" / "Cesium"
PREVIEW = ("-w", "cesium")

# Name -> DEM and options. Together they meet both profiles, both row orders, every extension.
SETS = {
    "shipped": ("jacksboro", *PREVIEW),
    "mercator": ("jacksboro", "-p", "mercator", "--xyz", *PREVIEW),
    "metadata": ("jacksboro", "--metadata", "4", *PREVIEW),
    "plain": ("jacksboro", "--compress", "none", "--no-normals", *PREVIEW),
    "all-nodes": ("small", "--method", "delaunay"),
    "global": ("global", "-z", "0-3", *PREVIEW),
    "antimeridian": ("antimeridian", *PREVIEW),
    "antimeridian-utm": ("antimeridian_utm",),
    "north-pole": ("north_pole", "-z", "0-5", *PREVIEW),
    "void": ("void", *PREVIEW),
    "bigtujunga": ("bigtujunga", *PREVIEW),
    "global-etopo": ("global_etopo", *PREVIEW),
}
WITH_PAGE = [name for name, made in SETS.items() if made[-2:] == PREVIEW]
# Default geodetic sets, where the DEM itself says what a client must find.
WITH_SAMPLES = ["shipped", "metadata", "global", "antimeridian", "antimeridian-utm", "bigtujunga",
                "global-etopo"]


@pytest.fixture
def made(tile_set):
    return lambda name: tile_set(SETS[name][0], *SETS[name][1:])


def succeeded(done):
    assert done.returncode == 0, done.stdout
    print(done.stdout)


def last_zoom(folder):
    return json.loads((folder / "layer.json").read_text())["maxzoom"]


@pytest.mark.parametrize("name", SETS)
def test_cesium_loads_every_tile(name, made, dem, node, tmp_path):
    folder = made(name)
    options = ["--no-encoding"] if name == "plain" else []
    if name in WITH_SAMPLES:
        samples = dem_samples(dem(SETS[name][0]), last_zoom(folder))
        assert len(samples) == 200
        (tmp_path / "samples.json").write_text(json.dumps(samples))
        options += ["--samples", tmp_path / "samples.json"]
    succeeded(node("cesium_all_tiles.mjs", folder, *options))


@pytest.mark.parametrize("name", SETS)
def test_loaders_gl_parses_every_tile(name, made, node):
    succeeded(node("loaders_all_tiles.mjs", made(name)))


def screenshots(name):
    keep = os.environ.get("QMESH_SCREENSHOTS")
    return ["--screenshots", pathlib.Path(keep) / name] if keep else []


@pytest.mark.parametrize("name", WITH_PAGE)
def test_preview_page_shows_the_set(name, made, node):
    succeeded(node("preview_page.mjs", made(name), *screenshots(name)))


def test_preview_page_switches_work_behind_a_plain_server(made, node):
    """One that sends gzip tiles without saying so, as Python's does."""
    succeeded(node("preview_page.mjs", made("shipped"), "--no-encoding", "--switches",
                   *screenshots("switches")))


def test_preview_page_explains_what_is_missing(made, node):
    succeeded(node("preview_messages.mjs", made("shipped")))


def test_preview_page_with_a_local_cesium(dem, node, tmp_path):
    output = tmp_path / "set"
    title = '<b>Tom & "Jerry"</b>'
    harness.gdal2qmesh(*PREVIEW, "--cesium", CESIUM, "-t", title, dem("small"), output).succeeded()
    copied = {p.relative_to(output / "Cesium") for p in (output / "Cesium").rglob("*")}
    assert copied == {p.relative_to(CESIUM) for p in CESIUM.rglob("*")}
    page = (output / "index.html").read_text()
    assert "https://" not in page
    assert "<title>&lt;b&gt;Tom &amp; &quot;Jerry&quot;&lt;/b&gt;</title>" in page
    assert not [p for p in output.iterdir() if p.name.startswith(".")]
    succeeded(node("preview_page.mjs", output))
    harness.gdal2qmesh("--overwrite", *PREVIEW, "--cesium", CESIUM.parent.parent, dem("small"),
                       output).succeeded()
    assert copied == {p.relative_to(output / "Cesium") for p in (output / "Cesium").rglob("*")}


def test_a_folder_without_cesium_is_refused_before_the_work(dem, tmp_path):
    run = harness.gdal2qmesh(*PREVIEW, "--cesium", tmp_path, dem("small"), tmp_path / "set")
    run.failed(harness.USAGE, "--cesium", tmp_path, "Build/Cesium")
    assert not (tmp_path / "set").exists()


@pytest.fixture(scope="module")
def formula_set(tmp_path_factory):
    """A good set the product had no part in."""
    return write_set(tmp_path_factory.mktemp("formula") / "set", max_zoom=2, cells=8)


def test_the_checks_accept_an_independent_set(formula_set, node):
    succeeded(node("cesium_all_tiles.mjs", formula_set))
    succeeded(node("loaders_all_tiles.mjs", formula_set))


def removed(path):
    path.unlink()


def cut_short(path):
    path.write_bytes(path.read_bytes()[:200])


@pytest.mark.parametrize("script", ["cesium_all_tiles.mjs", "loaders_all_tiles.mjs"])
@pytest.mark.parametrize("harm", [removed, cut_short])
def test_the_checks_notice_a_broken_tile(formula_set, node, tmp_path, harm, script):
    broken = tmp_path / "set"
    shutil.copytree(formula_set, broken)
    harm(broken / "2" / "3" / "1.terrain")
    done = node(script, broken)
    assert done.returncode != 0 and "2/3/1" in done.stdout, done.stdout


def test_the_checks_notice_a_wrong_height(formula_set, node, tmp_path):
    samples = tmp_path / "samples.json"
    samples.write_text(json.dumps([{"lon": 10, "lat": 20, "height": 99999, "tolerance": 1}]))
    done = node("cesium_all_tiles.mjs", formula_set, "--samples", samples)
    assert done.returncode != 0 and "99999" in done.stdout, done.stdout
