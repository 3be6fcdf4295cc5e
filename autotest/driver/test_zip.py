# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Archives as the place of a set: /vsizip/ on disk and in memory."""

import zipfile

import pytest
from osgeo import gdal

import harness
from made import SMALL, command_tree, hilly, read_file, refused, tree, write_file

OPTIONS = [*SMALL, "TITLE=t", "MAX_ZOOM=7"]


@pytest.fixture
def expected(qmesh, vsimem):
    qmesh.CreateCopy(vsimem + "/expected", hilly(), options=OPTIONS)
    return tree(vsimem + "/expected")


@pytest.mark.parametrize("name", ["a.zip", "deep/er/a.zip", "a.zip/terrain/set", "{a.ZIP.tmp}/x", "a.zip/"])
@pytest.mark.parametrize("where", ["disk", "vsimem"])
def test_a_set_in_an_archive(qmesh, vsimem, tmp_path, expected, where, name):
    base = str(tmp_path) if where == "disk" else vsimem
    place = "/vsizip/" + (f"{{{base}/{name[1:]}" if name[0] == "{" else f"{base}/{name}")
    made = qmesh.CreateCopy(place, hilly(), options=OPTIONS)
    assert made is not None and made.RasterCount == 1
    assert tree(place.rstrip("/")) == expected
    assert gdal.IdentifyDriver(place) is not None
    assert not [file for file in tree(base) if "qmesh-build" in file]


def test_the_archive_is_a_plain_one_and_the_same_each_time(qmesh, tmp_path, expected):
    for name, threads in (("a", 1), ("b", 4)):
        qmesh.CreateCopy(f"/vsizip/{tmp_path}/{name}.zip", hilly(), options=[*OPTIONS, f"NUM_THREADS={threads}"])
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        assert archive.testzip() is None
        assert archive.namelist()[-1] == "layer.json" and archive.namelist()[:-1] == sorted(archive.namelist()[:-1])
        kinds = {info.filename.rsplit(".", 1)[1]: info.compress_type for info in archive.infolist()}
        assert kinds == {"terrain": zipfile.ZIP_STORED, "json": zipfile.ZIP_DEFLATED}


def test_the_command_writes_archives_too(dem, command_set, tmp_path):
    words = ["--tilesize", "64", "--max-zoom", "7"]
    harness.gdal2qmesh(*words, dem("jacksboro"), f"/vsizip/{tmp_path}/a.zip").succeeded()
    assert tree(f"/vsizip/{tmp_path}/a.zip") == command_tree(command_set("jacksboro", *words))
    harness.gdal2qmesh(*words, dem("jacksboro"), f"/vsizip/{tmp_path}/a.zip").failed(harness.OUTPUT, "exists", "--overwrite")
    harness.gdal2qmesh("--overwrite", *words, dem("jacksboro"), f"/vsizip/{tmp_path}/a.zip").succeeded()


def test_an_archive_is_replaced_only_if_it_holds_just_that_set(qmesh, tmp_path):
    place = f"/vsizip/{tmp_path}/a.zip"
    qmesh.CreateCopy(place, hilly(), options=[*SMALL, "MAX_ZOOM=5"])
    qmesh.CreateCopy(place, hilly(), options=[*SMALL, "MAX_ZOOM=3"])
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        assert {name.split("/")[0] for name in archive.namelist()} == {"0", "1", "2", "3", "layer.json"}
    with zipfile.ZipFile(tmp_path / "a.zip", "a") as archive:
        archive.writestr("notes.txt", "mine")
    before = (tmp_path / "a.zip").read_bytes()
    refused(lambda: qmesh.CreateCopy(place, hilly(), options=SMALL), "not an archive of one set", number=gdal.CPLE_FileIO)
    refused(lambda: qmesh.CreateCopy(place + "/sub", hilly(), options=SMALL), "not an archive of one set")
    assert (tmp_path / "a.zip").read_bytes() == before
    write_file(str(tmp_path / "b.zip"), b"no archive at all")
    refused(lambda: qmesh.CreateCopy(f"/vsizip/{tmp_path}/b.zip", hilly(), options=SMALL), "b.zip", "not an archive")
    assert (tmp_path / "b.zip").read_bytes() == b"no archive at all"


def test_a_stop_leaves_no_archive(qmesh, tmp_path):
    refused(lambda: qmesh.CreateCopy(f"/vsizip/{tmp_path}/sub/a.zip", hilly(200, 200), options=SMALL,
                                     callback=lambda done, *_: 0 if done > 0 else 1), "stopped")
    assert list(tmp_path.iterdir()) == []


def test_what_cannot_be_done_in_an_archive_is_said(qmesh, tmp_path, vsimem):
    refused(lambda: qmesh.CreateCopy("/vsizip/nothing", hilly(), options=SMALL), "names no archive")
    place = f"/vsizip/{tmp_path}/a.zip"
    qmesh.CreateCopy(place, hilly(), options=[*SMALL, "MAX_ZOOM=3"])
    before = (tmp_path / "a.zip").read_bytes()
    refused(lambda: qmesh.Delete(place) == gdal.CE_None, "archive")
    refused(lambda: qmesh.Rename(f"/vsizip/{tmp_path}/b.zip", place) == gdal.CE_None, "archive")
    assert (tmp_path / "a.zip").read_bytes() == before
    assert qmesh.CopyFiles(vsimem + "/out", place) == gdal.CE_None  # reading from one works
    assert tree(vsimem + "/out") == tree(place)
    assert read_file(vsimem + "/out/layer.json")
