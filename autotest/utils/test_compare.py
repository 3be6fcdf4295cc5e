# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""gdal2qmesh --compare, against the terrain that the command itself makes with the same options."""

import csv

import numpy as np
import pytest
from osgeo import gdal

import dems
import harness
from oracle import tin
from oracle.scheme import Scheme, node_u
from oracle.tileset import TileSet

SIZE = ("--tilesize", 32)


@pytest.fixture(scope="module")
def hilly(tmp_path_factory):
    path = tmp_path_factory.mktemp("compare") / "hills.tif"
    return dems.write(path, dems.hills(200, 200), transform=(10.0, 0.002, 0.0, 47.0, 0.0, -0.002))


@pytest.fixture(scope="module")
def compared(hilly, tmp_path_factory):
    """(rows of comparison.csv by (target, method), stdout, folder, tile name)"""
    folder = tmp_path_factory.mktemp("compared") / "out"
    run = harness.gdal2qmesh("--compare", *SIZE, hilly, folder).succeeded()
    with open(folder / "comparison.csv", encoding="utf-8") as file:
        rows = {(row["target"], row["method"]): row for row in csv.DictReader(file)}
    tile = run.out.split(": tile ")[1].split(",")[0]
    return rows, run.out, folder, tuple(map(int, tile.split("/")))


def around(z, x, y):
    """A run of the tile and those it takes its halo from."""
    return ("-z", z, "--min-x", x - 1, "--max-x", x + 1, "--min-y", y - 1, "--max-y", y + 1)


def test_every_method_has_a_row_and_pictures(compared):
    rows, out, folder, _ = compared
    methods = {method for _, method in rows}
    assert {"greedy", "delaunay"} <= methods
    for method in methods:
        for target in ("defaults", "count", "error"):
            assert (target, method) in rows
        assert out.count(f"\n{method} ") == 3
        for target in ("count", "error"):
            picture = gdal.Open(str(folder / f"{method}-{target}.png"))
            assert (picture.RasterXSize, picture.RasterCount) == (512, 3)
            assert len(np.unique(picture.ReadAsArray())) > 20
    assert not list(folder.rglob("*.terrain")) and not (folder / "layer.json").exists()


@pytest.mark.parametrize("target", ["defaults", "count", "error"])
def test_the_rows_are_what_a_run_makes(compared, hilly, tmp_path, target):
    """Bytes, triangles, vertices of the very tile; its errors by the oracle's own evaluation."""
    rows, _, _, (z, x, y) = compared
    for (its_target, method), row in rows.items():
        if its_target != target:
            continue
        tuned = (f"--{row['option']}", row["value"]) if row["option"] else ()
        where = around(z, x, y)
        output = tmp_path / method
        harness.gdal2qmesh("-q", "--method", method, *SIZE, *where, *tuned, hilly, output).succeeded()
        tiles = TileSet(output)
        tile = tiles.tile(z, x, y)
        assert int(row["bytes"]) == tiles.path(z, x, y).stat().st_size
        assert int(row["triangles"]) == len(tile.triangles)
        assert int(row["vertices"]) == len(tile.u)
        reached = tiles.layer["qmesh"]["levels"][0]["errorReached"]  # of all nine
        assert float(row["max_error"]) <= reached * (1 + 1e-6)


def test_the_errors_are_those_of_the_nodes(compared, hilly, tmp_path):
    """Errors and angles of one row, computed anew from the tile of all nodes and the decoded tile."""
    rows, _, _, (z, x, y) = compared
    where = around(z, x, y)
    made = {}
    for method in ("greedy", "delaunay"):
        harness.gdal2qmesh("-q", "--method", method, *SIZE, *where, hilly, tmp_path / method).succeeded()
        made[method] = TileSet(tmp_path / method).tile(z, x, y)
    u, v = node_u(32), Scheme("geodetic").node_v(z, y, 32)
    error = np.abs(tin.evaluate(made["greedy"], u, v) - tin.evaluate(made["delaunay"], u, v))
    row = rows["defaults", "greedy"]
    slack = 2 * float(rows["defaults", "delaunay"]["max_error"])
    assert float(row["max_error"]) == pytest.approx(error.max(), abs=slack)
    assert float(row["mean_error"]) == pytest.approx(error.mean(), abs=slack)
    assert float(row["rms_error"]) == pytest.approx(np.sqrt((error**2).mean()), abs=slack)
    points = made["greedy"].ecef(Scheme("geodetic").box(z, x, y))
    corners = points[made["greedy"].triangles]
    angles = []
    for k in range(3):
        a = corners[:, (k + 1) % 3] - corners[:, k]
        b = corners[:, (k + 2) % 3] - corners[:, k]
        cosine = (a * b).sum(axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
        angles.append(np.degrees(np.arccos(cosine)))
    sharpest = np.min(angles, axis=0)
    assert float(row["min_angle"]) == pytest.approx(sharpest.min(), rel=0.02)
    assert float(row["mean_min_angle"]) == pytest.approx(sharpest.mean(), rel=0.01)


def test_a_second_comparison_writes_the_same_bytes(compared, hilly, tmp_path):
    harness.gdal2qmesh("-q", "--compare", *SIZE, hilly, tmp_path / "again").succeeded()
    assert harness.tree(tmp_path / "again") == harness.tree(compared[2])


def test_a_tile_or_a_region_can_be_chosen(hilly, tmp_path):
    one = harness.gdal2qmesh(
        "--compare", "--compare-tile", "8/270/194", "--tilesize", 8, hilly, tmp_path / "one"
    ).succeeded()
    assert "tile 8/270/194" in one.out
    region = harness.gdal2qmesh(
        "--compare", "-z", "10", "--min-x", 1081, "--max-x", 1082, "--min-y", 778, "--max-y", 778,
        "--tilesize", 8, hilly, tmp_path / "region",
    ).succeeded()
    assert "2 tiles of zoom 10" in region.out


def test_what_is_refused(hilly, compared, tmp_path):
    harness.gdal2qmesh("--compare-tile", "8/270/194", hilly, tmp_path / "a").failed(
        harness.USAGE, "--compare"
    )
    harness.gdal2qmesh("--compare", "--compare-tile", "8/1/1", hilly, tmp_path / "b").failed(
        harness.USAGE, "no tile"
    )
    harness.gdal2qmesh("--compare", *SIZE, hilly, compared[2]).failed(
        harness.OUTPUT, "--overwrite"
    )
    harness.gdal2qmesh("--compare", *SIZE, hilly, hilly).failed(harness.OUTPUT, "file")
