# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What happens to what is there: overwriting, deleting, moving, copying."""

import gzip
import os
import subprocess
import time

import dems
import pytest
from osgeo import gdal

import harness
from made import SMALL, array_source, hilly, refused, tree, write_file

OPTIONS = [*SMALL, "TITLE=t"]


@pytest.fixture(params=["disk", "vsimem"])
def place(request, tmp_path, vsimem):
    """A folder to work in, on disk and in memory."""
    return str(tmp_path) if request.param == "disk" else vsimem


def new_set(qmesh, folder, seed=11, options=OPTIONS):
    assert qmesh.CreateCopy(folder, array_source(dems.hills(60, 70, seed=seed)), options=options) is not None
    return tree(folder)


def statistics(path):
    """Of band 1; GDAL notes them beside the set."""
    opened = gdal.Open(path)
    return opened.GetRasterBand(1).ComputeStatistics(False)


def test_a_set_is_replaced(qmesh, place):
    new_set(qmesh, place + "/set", options=[*OPTIONS, "MAX_ZOOM=7"])
    for name in ("notes.txt", "3/readme.txt", "3/4/readme.txt", "other/5.terrain"):
        gdal.MkdirRecursive(os.path.dirname(place + "/set/" + name), 0o755)
        write_file(place + "/set/" + name, b"mine")
    expected = new_set(qmesh, place + "/expected", seed=3, options=[*OPTIONS, "MAX_ZOOM=5"])
    again = new_set(qmesh, place + "/set", seed=3, options=[*OPTIONS, "MAX_ZOOM=5"])
    foreign = {name for name in again if name not in expected}
    assert foreign == {"notes.txt", "3/readme.txt", "3/4/readme.txt", "other/5.terrain"}
    assert {name: again[name] for name in expected} == expected


def test_statistics_of_the_old_set_do_not_stay(qmesh, place):
    new_set(qmesh, place + "/set")
    old = statistics(place + "/set")
    assert statistics(place + "/set") == old
    new_set(qmesh, place + "/set", seed=4)
    assert statistics(place + "/set") != old


def test_what_is_no_set_is_refused(qmesh, place):
    gdal.MkdirRecursive(place + "/full", 0o755)
    write_file(place + "/full/notes.txt", b"mine")
    before = tree(place)
    refused(lambda: qmesh.CreateCopy(place + "/full", hilly(), options=OPTIONS), "not empty", number=gdal.CPLE_FileIO)
    write_file(place + "/full/layer.json", b'{"format": "something else"}')
    refused(lambda: qmesh.CreateCopy(place + "/full", hilly(), options=OPTIONS), "not empty")
    refused(lambda: qmesh.CreateCopy(place + "/full/notes.txt/deep", hilly(), options=OPTIONS), "notes.txt")
    gdal.Unlink(place + "/full/layer.json")
    assert tree(place) == before


def test_an_empty_folder_is_taken(qmesh, place):
    gdal.MkdirRecursive(place + "/empty", 0o755)
    assert new_set(qmesh, place + "/empty") == new_set(qmesh, place + "/other")


def test_a_failed_run_leaves_the_set(qmesh, place):
    before = new_set(qmesh, place + "/set")
    nowhere = array_source(dems.hills(20, 20), transform=None)
    refused(lambda: qmesh.CreateCopy(place + "/set", nowhere, options=OPTIONS), "not georeferenced")
    refused(lambda: qmesh.CreateCopy(place + "/set", hilly(), options=["METHOD=best"]), "METHOD=best")
    assert tree(place + "/set") == before


@pytest.mark.parametrize("name", ["set", "set/", "QMESH:set", "set/layer.json"])
def test_delete_removes_our_files_only(qmesh, place, name):
    new_set(qmesh, place + "/set")
    prefix, path = ("QMESH:", name[6:]) if name.startswith("QMESH:") else ("", name)
    for foreign in ("notes.txt", "5/readme.txt", "index.html"):
        write_file(place + "/set/" + foreign, b"<!-- mine -->")
    assert qmesh.Delete(f"{prefix}{place}/{path}") == gdal.CE_None
    assert set(tree(place + "/set")) == {"notes.txt", "5/readme.txt", "index.html"}
    assert gdal.IdentifyDriver(place + "/set") is None


def test_delete_leaves_no_folder_of_a_set_alone(qmesh, place):
    new_set(qmesh, place + "/set")
    statistics(place + "/set")
    assert qmesh.Delete(place + "/set") == gdal.CE_None
    assert tree(place) == {} and gdal.VSIStatL(place + "/set") is None


def test_delete_takes_the_preview_page_of_the_command(qmesh, dem, tmp_path):
    harness.gdal2qmesh("--tilesize", "64", "--max-zoom", "6", "-w", "cesium", dem("jacksboro"), tmp_path / "set").succeeded()
    assert (tmp_path / "set" / "index.html").exists()
    assert qmesh.Delete(str(tmp_path / "set")) == gdal.CE_None
    assert list(tmp_path.iterdir()) == []


def test_as_newer_gdal_replaces_a_set(qmesh, place):
    """GDAL 3.11 deletes a set before it has the driver write the new one; foreign files are in the folder then."""
    new_set(qmesh, place + "/set")
    write_file(place + "/set/notes.txt", b"mine")
    assert qmesh.Delete(place + "/set") == gdal.CE_None
    expected = new_set(qmesh, place + "/expected", seed=3)
    again = new_set(qmesh, place + "/set", seed=3)
    assert set(again) - set(expected) == {"notes.txt"} and {n: again[n] for n in expected} == expected
    assert qmesh.Delete(place + "/expected") == gdal.CE_None  # and that holds for that folder only
    gdal.MkdirRecursive(place + "/full", 0o755)
    write_file(place + "/full/notes.txt", b"mine")
    refused(lambda: qmesh.CreateCopy(place + "/full", hilly(), options=OPTIONS), "not empty")


def test_delete_refuses_what_is_no_set(qmesh, place):
    gdal.MkdirRecursive(place + "/full/0/0", 0o755)
    write_file(place + "/full/0/0/0.terrain", b"x")
    refused(lambda: qmesh.Delete(place + "/full") == gdal.CE_None, "not a quantized-mesh set")
    refused(lambda: qmesh.Delete(place + "/none") == gdal.CE_None, "not a quantized-mesh set")
    refused(lambda: qmesh.Delete("QMESH:" + place + "/full") == gdal.CE_None, "not a quantized-mesh set")
    assert set(tree(place)) == {"full/0/0/0.terrain"}


def test_gdalmanage(qmesh, tmp_path):
    def gdalmanage(*words):
        return subprocess.run(["gdalmanage", *words], cwd=tmp_path, capture_output=True, text=True, check=True).stdout

    before = new_set(qmesh, str(tmp_path / "set"))
    assert "QMESH" in gdalmanage("identify", "set")
    gdalmanage("copy", "set", "twin")
    gdalmanage("rename", "twin", "moved")
    assert not (tmp_path / "twin").exists()
    assert tree(tmp_path / "set") == tree(tmp_path / "moved") == before
    gdalmanage("delete", "set")
    assert not (tmp_path / "set").exists()


def test_rename_and_copy_keep_foreign_files_where_they_are(qmesh, place):
    before = new_set(qmesh, place + "/set")
    write_file(place + "/set/notes.txt", b"mine")
    assert qmesh.CopyFiles(place + "/copy", place + "/set") == gdal.CE_None
    assert tree(place + "/copy") == before
    assert qmesh.Rename(place + "/moved/deep", place + "/set") == gdal.CE_None
    assert tree(place + "/moved/deep") == before and set(tree(place + "/set")) == {"notes.txt"}
    assert gdal.IdentifyDriver(place + "/set") is None and gdal.IdentifyDriver(place + "/moved/deep") is not None


def test_rename_to_another_file_system(qmesh, tmp_path, vsimem):
    before = new_set(qmesh, str(tmp_path / "set"))
    assert qmesh.Rename(vsimem + "/set", str(tmp_path / "set")) == gdal.CE_None
    assert tree(vsimem + "/set") == before and not (tmp_path / "set").exists()


def test_rename_and_copy_refuse_a_target_that_is_there(qmesh, place):
    before = new_set(qmesh, place + "/set")
    new_set(qmesh, place + "/other", seed=2)
    refused(lambda: qmesh.Rename(place + "/other", place + "/set") == gdal.CE_None, "exists already")
    refused(lambda: qmesh.CopyFiles(place + "/other", place + "/set") == gdal.CE_None, "exists already")
    refused(lambda: qmesh.Rename(place + "/new", place + "/none") == gdal.CE_None, "not a quantized-mesh set")
    assert tree(place + "/set") == before


def test_a_tile_is_a_dataset_too(qmesh, place):
    new_set(qmesh, place + "/set")
    gdal.MkdirRecursive(place + "/other/1/2", 0o755)
    one, two = place + "/other/1/2/0.terrain", place + "/other/1/2/1.terrain"
    assert qmesh.CopyFiles(one, place + "/set/0/1/0.terrain") == gdal.CE_None
    assert qmesh.Rename(two, one) == gdal.CE_None
    assert gdal.VSIStatL(one) is None
    assert gdal.IdentifyDriver(two) is not None
    assert qmesh.Delete(two) == gdal.CE_None
    assert gdal.VSIStatL(two) is None


def test_other_drivers_keep_their_files(qmesh, tmp_path):
    """Nothing that is not terrain is taken for it."""
    (tmp_path / "layer.json").write_text('{"type": "FeatureCollection", "features": []}')
    (tmp_path / "a.terrain").write_bytes(b"hello, I am a text of some length" * 20)
    (tmp_path / "empty.terrain").write_bytes(b"")
    (tmp_path / "3" / "4").mkdir(parents=True)
    (tmp_path / "3" / "4" / "5.terrain").write_bytes(bytes(range(256)) * 4)
    (tmp_path / "3" / "4" / "6.terrain").write_bytes(gzip.compress(b"heightmap" * 50))
    (tmp_path / "packed.terrain").write_bytes(gzip.compress(b"something else" * 50))
    for path in [path for path in sorted(tmp_path.rglob("*"))] + [tmp_path, harness.SHIPPED, harness.SHIPPED.parent]:
        found = gdal.IdentifyDriverEx(str(path), allowed_drivers=["QMESH"])
        assert found is None, path


def test_a_run_in_the_same_folder_is_seen(qmesh, tmp_path):
    (tmp_path / "set" / ".qmesh-build").mkdir(parents=True)
    lock = tmp_path / "set" / ".qmesh-build" / "lock"
    holder = subprocess.Popen(["flock", str(lock), "sleep", "60"])
    try:
        for _ in range(200):
            time.sleep(0.02)
            if lock.exists() and subprocess.run(["flock", "-n", str(lock), "true"], check=False).returncode:
                break
        refused(lambda: qmesh.CreateCopy(str(tmp_path / "set"), hilly(), options=OPTIONS), "another run")
    finally:
        holder.kill()
        holder.wait()
