# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Progress from the calling thread, and what a stop leaves: nothing that is a dataset."""

import threading

import pytest
from osgeo import gdal

from made import SMALL, hilly, refused, tree, write_file


def make(qmesh, place, stop_at=2.0, **options):
    """CreateCopy that is stopped when `stop_at` is reached; returns (progress told, threads it came from)."""
    told, threads = [], set()

    def progress(done, message, data):
        told.append(done)
        threads.add(threading.get_ident())
        return 1 if done < stop_at else 0

    def run():
        return qmesh.CreateCopy(place, hilly(300, 300), options=[*SMALL, "NUM_THREADS=2"], callback=progress, **options)

    if stop_at <= 1:
        refused(run, "stopped", number=gdal.CPLE_UserInterrupt)
    else:
        assert run() is not None
    return told, threads


def test_progress_is_monotone_from_the_calling_thread(qmesh, vsimem):
    told, threads = make(qmesh, vsimem + "/set")
    assert told[0] == 0 and told[-1] == 1 and all(0 <= t <= 1 for t in told)
    assert told == sorted(told) and len(told) > 3
    assert threads == {threading.get_ident()}


@pytest.mark.parametrize("stop_at", [0.0, 1e-9, 0.3])
@pytest.mark.parametrize("where", ["disk", "vsimem"])
def test_a_stop_leaves_nothing(qmesh, vsimem, tmp_path, where, stop_at):
    place = vsimem + "/set" if where == "vsimem" else str(tmp_path / "set")
    make(qmesh, place, stop_at)
    assert gdal.VSIStatL(place) is None
    assert gdal.IdentifyDriver(place) is None
    assert tree(vsimem) == {} and list(tmp_path.iterdir()) == []
    told, _ = make(qmesh, place)  # and the next one works
    assert told[-1] == 1


@pytest.mark.parametrize("where", ["disk", "vsimem"])
def test_a_stop_leaves_the_set_that_was_there(qmesh, vsimem, tmp_path, where):
    place = vsimem + "/set" if where == "vsimem" else str(tmp_path / "set")
    qmesh.CreateCopy(place, hilly(60, 60), options=SMALL)
    write_file(place + "/notes.txt", b"mine")
    before = tree(place)
    make(qmesh, place, 0.3)
    assert tree(place) == before


def test_an_exception_in_the_callback(qmesh, vsimem):
    def progress(done, message, data):
        raise ValueError("enough")

    with pytest.raises(Exception):
        qmesh.CreateCopy(vsimem + "/set", hilly(), options=SMALL, callback=progress)
    assert tree(vsimem) == {}
