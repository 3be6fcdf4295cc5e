# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""P3: the same input and options give the same bytes, however the work is cut up."""

import pytest

import harness

WAYS = {
    "one thread": ("-j", "1"),
    "two threads": ("-j", "2"),
    "seven threads": ("-j", "7"),
    "small blocks": ("-j", "2", "--block-tiles", "2"),
    "middle blocks": ("-j", "1", "--block-tiles", "4"),
    "large blocks": ("-j", "2", "--block-tiles", "8"),
    "much memory": ("--memory", "2GB"),
}


@pytest.mark.parametrize("name", ["jacksboro", "void", "global", "antimeridian_utm", "sthelens"])
def test_the_tree_does_not_depend_on_how_the_work_is_cut(dem, tmp_path, name):
    trees = {}
    for way, options in WAYS.items():
        output = tmp_path / way
        harness.gdal2qmesh("-q", *options, dem(name), output).succeeded()
        trees[way] = harness.tree(output)
    first = trees["one thread"]
    assert len(first) > 15
    for way, found in trees.items():
        differing = [k for k in first.keys() | found.keys() if first.get(k) != found.get(k)]
        assert differing == [], f"{way}: {len(differing)} files differ, for example {differing[:3]}"


def minimum_memory(dem, *options):
    """What --memory must be at least, as the command itself says, in its own words."""
    run = harness.gdal2qmesh("-q", "--memory", "1MB", *options, dem, "nowhere-at-all")
    run.failed(harness.USAGE, "memory")
    words = run.err.split()
    numbers = [w.strip(".,;:()") for w in words if w.strip(".,;:()")[:1].isdigit()]
    return numbers


def test_the_smallest_memory_gives_the_same_tree(dem, tmp_path):
    """The message names the minimum; with it the command works, and writes the same."""
    harness.gdal2qmesh("-q", dem("void"), tmp_path / "usual").succeeded()
    named = minimum_memory(dem("void"), "-j", "1")
    for number in named:
        run = harness.gdal2qmesh(
            "-q", "-j", "1", "--memory", f"{number.rstrip('MB')}MB", dem("void"), tmp_path / "tight"
        )
        if run.code == harness.DONE:
            break
    assert run.code == harness.DONE, f"none of {named} works as --memory: {run.err}"
    assert harness.tree(tmp_path / "tight") == harness.tree(tmp_path / "usual")


def test_a_second_run_writes_the_same_bytes(dem, tmp_path):
    for output in ("a", "b"):
        harness.gdal2qmesh("-q", "-w", "cesium", dem("small"), tmp_path / output).succeeded()
    assert harness.tree(tmp_path / "a") == harness.tree(tmp_path / "b")


def test_the_default_output_is_the_inputs_name_in_the_current_folder(dem, tmp_path):
    harness.gdal2qmesh("-q", dem("small"), tmp_path / "named").succeeded()
    harness.gdal2qmesh("-q", dem("small"), cwd=tmp_path).succeeded()
    assert harness.tree(tmp_path / "small") == harness.tree(tmp_path / "named")
