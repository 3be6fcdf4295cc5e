# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""--debug-meshes: every tile's mesh for programs that show meshes."""

import numpy as np
import pytest

import harness
from oracle.tileset import TileSet

OPTIONS = ("-q", "--tilesize", 16, "-z", "7-9")


def read_off(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    assert lines[0] == "OFF"
    vertices, faces = map(int, lines[1].split()[:2])
    points = [line.split()[:3] for line in lines[2 : 2 + vertices]]
    return points, [line.split()[1:4] for line in lines[2 + vertices : 2 + vertices + faces]]


def read_obj(text):
    rows = [line.split() for line in text.splitlines()]
    points = [row[1:4] for row in rows if row and row[0] == "v"]
    faces = [[str(int(p.split("/")[0]) - 1) for p in row[1:]] for row in rows if row and row[0] == "f"]
    return points, faces


def read_ply(text):
    head, body = text.split("end_header\n")
    count = int(head.split("element vertex ")[1].split()[0])
    lines = body.splitlines()
    return [line.split()[:3] for line in lines[:count]], [line.split()[1:4] for line in lines[count:]]


READERS = {"off": read_off, "obj": read_obj, "ply": read_ply}


@pytest.mark.parametrize("border", ["shared", "inherit"])
@pytest.mark.parametrize("kind", READERS)
def test_every_tile_has_its_mesh(tmp_path, kind, border):
    harness.gdal2qmesh(
        *OPTIONS, "--border", border, "--debug-meshes", tmp_path / "meshes", "--debug-format", kind,
        harness.SHIPPED, tmp_path / "out",
    ).succeeded()
    tiles = TileSet(tmp_path / "out")
    files = sorted(p.relative_to(tmp_path / "meshes").as_posix() for p in (tmp_path / "meshes").rglob("*.*"))
    assert files == sorted(f"{z}/{x}/{y}.{kind}" for z, x, y in tiles.available())
    for name in tiles.available():
        text = (tmp_path / "meshes" / f"{'/'.join(map(str, name))}.{kind}").read_text()
        points, faces = READERS[kind](text)
        tile = tiles.tile(*name)
        assert np.array_equal(np.array(faces, int), tile.triangles)
        # Metres east, north and up: as far apart as in the decoded tile.
        there = np.array(points, float)
        here = tile.ecef(tiles.scheme.box(*name))
        assert len(there) == len(here)
        assert np.allclose(
            np.linalg.norm(there - there[0], axis=1), np.linalg.norm(here - here[0], axis=1), atol=2e-3
        )


def test_the_rows_are_numbered_as_in_the_set(tmp_path):
    harness.gdal2qmesh(
        *OPTIONS, "--xyz", "--debug-meshes", tmp_path / "meshes", harness.SHIPPED, tmp_path / "out"
    ).succeeded()
    names = {p.relative_to(tmp_path / "out").with_suffix("") for p in (tmp_path / "out").rglob("*.terrain")}
    assert names == {p.relative_to(tmp_path / "meshes").with_suffix("") for p in (tmp_path / "meshes").rglob("*.ply")}


def test_the_tiles_are_the_same_with_and_without(tmp_path):
    harness.gdal2qmesh(*OPTIONS, harness.SHIPPED, tmp_path / "a").succeeded()
    harness.gdal2qmesh(*OPTIONS, "--debug-meshes", tmp_path / "m", harness.SHIPPED, tmp_path / "b").succeeded()
    assert harness.tree(tmp_path / "a") == harness.tree(tmp_path / "b")


def test_a_folder_that_cannot_be_written_is_said(tmp_path):
    (tmp_path / "file").write_text("mine")
    run = harness.gdal2qmesh(
        *OPTIONS, "--debug-meshes", tmp_path / "file", harness.SHIPPED, tmp_path / "out"
    )
    run.failed(harness.OUTPUT, "file")
    assert (tmp_path / "file").read_text() == "mine" and not (tmp_path / "out").exists()
