# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""A run that is stopped: exit 3, nothing broken left, what was there before still there."""

import shutil
import signal
import time

import pytest

import dems
import harness

SLOW = ("-q", "-j", "1", "--tilesize", "64")  # many small tiles: seconds of work


@pytest.fixture(scope="module")
def large(tmp_path_factory):
    return dems.write(
        tmp_path_factory.mktemp("large") / "large.tif", dems.hills(3000, 3000),
        (10.0, 0.0002, 0.0, 47.0, 0.0, -0.0002),
    )


def wait_for_tiles(process, output, number=1):
    """Returns when so many tiles lie in the output folder and those hidden in it."""
    deadline = time.monotonic() + 60
    while len(list(output.rglob("*.terrain")) if output.exists() else []) < number:
        assert process.poll() is None, "it ended before it was stopped"
        assert time.monotonic() < deadline, "no tile was written within a minute"
        time.sleep(0.02)
    time.sleep(0.1)


def stop_in_the_middle(process, output, number):
    """Sends the signal once tiles are being written."""
    wait_for_tiles(process, output)
    assert process.poll() is None, "it ended before it was stopped"
    process.send_signal(number)
    _, err = process.communicate(timeout=60)
    return process.returncode, err.decode()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_leaves_nothing(tmp_path, large, number):
    output = tmp_path / "out"
    code, err = stop_in_the_middle(harness.start(*SLOW, large, output), output, number)
    assert code == harness.INTERRUPTED, err
    assert "stopped" in err
    assert not output.exists() or harness.tree(output) == {}


def test_a_signal_keeps_the_old_set(tmp_path, large):
    """While the new set is built the old one stays whole, and after the signal too."""
    output = tmp_path / "out"
    harness.gdal2qmesh("-q", "-z", "0-4", large, output).succeeded()
    (output / "notes.txt").write_text("mine")
    before = harness.tree(output)
    kept = shutil.copytree(output, tmp_path / "kept")
    process = harness.start(*SLOW, "--overwrite", large, output)
    wait_for_tiles(process, output, 1 + sum(name.endswith(".terrain") for name in before))
    during = {name: harness.tree(output / name) for name in ("0", "4")}
    assert process.poll() is None, "it ended before it was looked at"
    assert during == {name: harness.tree(kept / name) for name in ("0", "4")}
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == harness.INTERRUPTED, err.decode()
    assert harness.tree(output) == before


def test_after_a_kill_the_next_run_clears_up(tmp_path, large):
    output = tmp_path / "out"
    code, _ = stop_in_the_middle(harness.start(*SLOW, large, output), output, signal.SIGKILL)
    assert code == -signal.SIGKILL
    assert not (output / "layer.json").exists()
    assert not [p for p in output.glob("[0-9]*/**/*.terrain")], "a tile of half a set is visible"
    harness.gdal2qmesh("-q", "-z", "0-3", large, output).succeeded()
    harness.gdal2qmesh("-q", "-z", "0-3", large, tmp_path / "fresh").succeeded()
    assert harness.tree(output) == harness.tree(tmp_path / "fresh")


def test_two_runs_do_not_share_an_output(tmp_path, large):
    output = tmp_path / "out"
    first = harness.start(*SLOW, large, output)
    while not output.exists() or not any(output.rglob("*.terrain")):
        assert first.poll() is None
        time.sleep(0.02)
    second = harness.gdal2qmesh("-q", "--overwrite", "-z", "0-3", large, output)
    still_running = first.poll() is None
    first.send_signal(signal.SIGTERM)
    first.communicate(timeout=60)
    assert still_running, "the first run ended too early for this test"
    second.failed(harness.OUTPUT, "out")
    assert first.returncode == harness.INTERRUPTED
