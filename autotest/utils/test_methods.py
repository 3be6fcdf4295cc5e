# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Every method of the command on real terrain: P1, P2 where it bounds the error, P3 and P6. A few
zooms with small tiles, at most 40 tiles a set; with QMESH_FULL all zooms with tiles of 256 cells."""

import json
import subprocess

import pytest

import harness
import promises
from infos import CLEAN, findings

BOUNDED = {"greedy", "collapse"}  # within the max error with their defaults
BOUNDED_WHEN_ASKED = {"quadtree"}  # with --max-error
UNBOUNDED = {"delaunay", "qem", "quadtree", "grid", "random", "hierarchy", "wlop"}
DEMS = {
    "small_bigtujunga": "12-",
    "small_montereybay": "9-",
    "small_celticsea": "6-",
    "small_slovenia": "16-",
    "small_global": "0-",
}
MOST_TILES = 40
# The command samples these where the oracle does, so the errors told can be compared.
AFFINE = {"small_celticsea", "small_global"}


def methods_of_this_build():
    text = subprocess.run(
        [str(harness.BIN), "--options-json"], capture_output=True, check=True, text=True
    ).stdout
    rows = {row["name"]: row for row in json.loads(text)["options"]}
    return [choice["name"] for choice in rows["method"]["choices"]]


METHODS = methods_of_this_build()
# A schedule a DEM for --border inherit, so that all of them are used.
SCHEDULES = dict(zip(DEMS, ["four-colour", "rowwise", "columnwise", "chessboard", "4connected"]))
every_set = pytest.mark.parametrize(
    "method, name, border",
    [(m, name, b) for m in METHODS for name in DEMS for b in ("shared", "inherit")],
)


def options(method, name, border="shared"):
    common = ("-q", "--method", method)
    if border == "inherit":
        common += ("--border", border, "--schedule", SCHEDULES[name])
    return common if harness.FULL else (*common, "--tilesize", 64, "-z", DEMS[name])


def cells():
    return 256 if harness.FULL else 64


@pytest.mark.parametrize("method", METHODS)
def test_it_is_known_what_a_method_promises(method):
    assert method in BOUNDED | UNBOUNDED, "say in this file whether it bounds the error"


@every_set
def test_every_tile_is_valid_and_no_seam_shows(tile_set, method, name, border):
    """P6, P1"""
    tiles = tile_set(name, *options(method, name, border))
    assert harness.FULL or len(tiles.available()) <= MOST_TILES
    promises.none(promises.valid(tiles))
    faults, seams = promises.seamless(tiles)
    promises.none(faults)
    assert seams > 0


@every_set
def test_the_error_is_bounded_or_told(tile_set, dem, method, name, border):
    """P2 for the methods that promise it; every method says how far off it is."""
    tiles = tile_set(name, *options(method, name, border))
    nodes = promises.nodes_of(dem(name), "geodetic", cells(), max(tiles.levels()))
    faults, reached = promises.bounded(tiles, nodes, promised=method in BOUNDED)
    promises.none(faults)
    if name in AFFINE:
        for level in tiles.layer["qmesh"]["levels"]:
            assert level["errorReached"] == pytest.approx(reached[level["zoom"]], abs=2e-3)


@pytest.mark.parametrize("name", DEMS)
@pytest.mark.parametrize("border", ["shared", "inherit"])
@pytest.mark.parametrize("method", sorted(BOUNDED_WHEN_ASKED))
def test_the_error_is_bounded_when_asked(tile_set, dem, method, border, name):
    """P2 for the methods that go by their own measure unless --max-error is given."""
    asked = ("--max-error", "20000/2^z")
    tiles = tile_set(name, *options(method, name, border), *asked)
    nodes = promises.nodes_of(dem(name), "geodetic", cells(), max(tiles.levels()))
    promises.none(promises.bounded(tiles, nodes, lambda z: 20000 / 2**z)[0])
    promises.none(promises.valid(tiles))


@pytest.mark.parametrize("border", ["shared", "inherit"])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", DEMS if harness.FULL else ["small_montereybay", "small_global"])
def test_the_bytes_do_not_depend_on_the_work(dem, tile_set, tmp_path, method, name, border):
    """P3"""
    usual = tile_set(name, *options(method, name, border))
    other = tmp_path / "other"
    run = harness.gdal2qmesh(
        *options(method, name, border), "-j", 3, "--block-tiles", 2, dem(name), other
    )
    run.succeeded()
    assert harness.tree(other) == harness.tree(usual.folder)


@pytest.mark.parametrize("border", ["shared", "inherit"])
@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
@pytest.mark.parametrize("method", METHODS)
def test_a_set_of_the_shipped_dem_is_without_findings(tmp_path, method, profile, border):
    """From the globe to the terrain: nothing but notes from qmeshinfo --validate."""
    usual = (profile, border) == ("geodetic", "shared")
    size = () if harness.FULL or usual else ("--tilesize", 64, "-z", "0-9")
    harness.gdal2qmesh("-q", "--method", method, "-p", profile, "--border", border, *size,
                       harness.SHIPPED, tmp_path / "set").succeeded()
    found, code = findings(tmp_path / "set")
    assert [f for f in found.values() if f["severity"] != "note"] == []
    assert code == CLEAN


def triangles(tiles):
    return sum(len(tiles.tile(*name).triangles) for name in tiles.available())


@pytest.mark.parametrize("method", [m for m in METHODS if m != "delaunay"])
def test_without_parameters_it_makes_about_as_many_triangles_as_greedy(tile_set, method):
    """On ordinary terrain: mountains at the DEM's own resolution."""
    mine = triangles(tile_set("small_bigtujunga", *options(method, "small_bigtujunga")))
    greedy = triangles(tile_set("small_bigtujunga", *options("greedy", "small_bigtujunga")))
    assert greedy / 4 < mine < greedy * 4
