# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Damaged and hostile files: an error or a result, never a crash, a hang or a full memory."""

import gzip
import json
import os
import random
import resource
import struct
import subprocess
import sys

import numpy as np
import pytest
from osgeo import gdal

import harness
from formula_sets import Writer, pyramid
from looking import raster, vector
from made import messages

ROUNDS = 400 if harness.FULL else 120


def one_tile_set(folder, **options):
    writer = Writer(folder, **options)
    writer.write_level(0, 0, 0, 1, 0)
    writer.write_layer()
    return writer


def look_at_everything(name):
    """Reads raster and vector; True where all of it could be read."""
    ok = True
    with messages():
        for action in (
            lambda: raster(name).ReadAsArray(0, 0, 300, 256),
            lambda: raster(name, REGISTRATION="NODE", FILL="PARENT").ReadAsArray(0, 0, 257, 257),
            lambda: [f for k in range(3) for f in _layer(vector(name, GEOMETRY="POLYGONS"), k)],
            lambda: [f for k in range(3) for f in _layer(vector(name), k)],
        ):
            try:
                ok &= action() is not None
            except RuntimeError:
                ok = False
    return ok


def _layer(dataset, k):
    return [(f.GetFID(), f.geometry() is None) for f in dataset.GetLayer(k)]


def mutated(data, source):
    """Some bytes changed, cut, doubled or filled."""
    data = bytearray(data)
    for _ in range(source.randint(1, 6)):
        at = source.randrange(len(data) or 1)
        kind = source.randrange(5)
        if kind == 0 and data:
            data[at] = source.randrange(256)
        elif kind == 1:
            data[at : at + 4] = struct.pack("<I", source.choice([0, 1, 0x7FFFFFFF, 0xFFFFFFFF, 65535, 65536, 1 << 20]))
        elif kind == 2:
            del data[at : at + source.randint(1, 40)]
        elif kind == 3:
            data[at:at] = data[at : at + source.randint(1, 40)]
        elif data:
            data[at : at + 8] = b"\xff" * 8
    return bytes(data)


def test_random_damage_to_a_tile(tmp_path):
    writer = one_tile_set(tmp_path, compress=False)
    good = writer.tile(0, 0, 0)
    source, failures = random.Random(17), 0
    assert look_at_everything(tmp_path)
    for _ in range(ROUNDS):
        writer.write_tile(0, 0, 0, mutated(good, source))
        failures += not look_at_everything(tmp_path)
    assert ROUNDS / 4 < failures


def test_every_truncation_of_a_tile(tmp_path):
    writer = one_tile_set(tmp_path, compress=False, cells=2)
    good = writer.tile(0, 0, 0)
    ends = range(len(good)) if harness.FULL else range(0, len(good), 5)
    without_extensions = len(good) - 5 - 2 * 9
    for end in ends:
        writer.write_tile(0, 0, 0, good[:end])
        dataset = raster(tmp_path)
        with messages():
            try:
                dataset.ReadAsArray(0, 0, 256, 256)
                assert end == without_extensions
            except RuntimeError as error:
                assert "0/0/0.terrain" in str(error)


def test_a_damaged_tile_is_one_error_that_names_it(tmp_path):
    writer = one_tile_set(tmp_path)
    path = writer.path(0, 0, 0)
    path.write_bytes(path.read_bytes()[:60])
    dataset = raster(tmp_path)
    with messages() as said:
        with pytest.raises(RuntimeError, match="0/0/0.terrain"):
            dataset.ReadAsArray(0, 0, 256, 256)
    ours = [text for _, _, text in said if text.startswith("QMESH: ")]
    assert len(ours) == 1 and "0/0/0.terrain" in ours[0] and "gzip" in ours[0]


def test_gzip_that_unpacks_to_far_too_much(tmp_path):
    writer = one_tile_set(tmp_path)
    packed = gzip.compress(bytes(200 << 20), 9, mtime=0)
    assert len(packed) < 1 << 20
    writer.path(0, 0, 0).write_bytes(packed)
    with pytest.raises(RuntimeError, match="0/0/0.terrain.*limit"):
        raster(tmp_path).ReadAsArray(0, 0, 256, 256)


@pytest.mark.parametrize("what", ["nan", "inf", "huge", "reversed"])
def test_strange_heights(tmp_path, what):
    writer = one_tile_set(tmp_path, compress=False)
    tile = bytearray(writer.tile(0, 0, 0))
    tile[24:32] = struct.pack("<2f", *{"nan": (float("nan"), 1), "inf": (0, float("inf")), "huge": (-3e38, 3e38),
                                      "reversed": (100, -100)}[what])
    writer.write_tile(0, 0, 0, bytes(tile))
    with messages():
        try:
            values = raster(tmp_path).ReadAsArray(0, 0, 256, 256)
            assert what in ("huge", "reversed") and np.isfinite(values).all()
        except RuntimeError:
            assert what in ("nan", "inf")


def test_all_triangles_across_the_whole_tile(tmp_path):
    """Much work per triangle, but bounded."""
    writer = one_tile_set(tmp_path, compress=False)
    tile = bytearray(writer.tile(0, 0, 0))
    count = 20000
    start = 88 + 4 + 25 * 6
    body = struct.pack("<I", count) + np.tile(np.array([0, 0, 0], "<u2"), 1).tobytes()
    body += np.tile(np.array([3, 2, 1], "<u2"), count - 1).tobytes()
    writer.write_tile(0, 0, 0, bytes(tile[:start]) + body + bytes(16))
    look_at_everything(tmp_path)


def test_random_damage_to_layer_json(tmp_path):
    pyramid(tmp_path, top=1).write_layer(metadataAvailability=3, bounds=[-180, -90, 180, 90], qmesh={
        "method": "greedy", "cellsPerTile": 64, "levels": [{"zoom": 1, "maxError": 3, "errorReached": 2}]})
    layer = tmp_path / "layer.json"
    good = layer.read_bytes()
    source = random.Random(23)
    for _ in range(ROUNDS):
        layer.write_bytes(mutated(good, source))
        look_at_everything(f"QMESH:{tmp_path}")


VALUES = [None, -1, 0, 1e300, 2**40, "", "x", [], {}, True, "../../../etc/passwd", [[]], [{}], "{z}", 24, 25]


@pytest.mark.parametrize("key", ["format", "tiles", "projection", "scheme", "available", "maxzoom", "minzoom", "bounds",
                                 "version", "extensions", "metadataAvailability", "qmesh", "name"])
def test_values_of_other_kinds(tmp_path, key):
    folder = pyramid(tmp_path, top=1).write_layer()
    good = json.loads((folder / "layer.json").read_text())
    for value in [*VALUES, [value for value in VALUES]]:
        (folder / "layer.json").write_text(json.dumps({**good, key: value}))
        look_at_everything(f"QMESH:{folder}")


HUGE = """
import sys
sys.path[:0] = {paths!r}
import resource
resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
from osgeo import gdal
gdal.UseExceptions()
for flags in (gdal.OF_RASTER, gdal.OF_VECTOR):
    try:
        dataset = gdal.OpenEx({name!r}, flags, open_options={options!r})
        if flags == gdal.OF_RASTER:
            dataset.ReadAsArray(0, 0, 256, 256)
        else:
            for k in range(dataset.GetLayerCount()):
                layer = dataset.GetLayer(k)
                layer.SetSpatialFilterRect(-180, -90, -179.9, -89.9)
                layer.GetExtent()
                layer.SetIgnoredFields(["zoom"])
                layer.GetNextFeature()
    except RuntimeError as error:
        assert "memory" not in str(error).lower(), error
print("done")
"""


@pytest.mark.parametrize("case", ["deep", "overlapping", "comb"])
def test_a_few_bytes_cannot_fill_the_memory(tmp_path, case):
    """Levels of 2^49 tiles, overlapping or in stripes: seconds, and far below 3 GB."""
    writer = pyramid(tmp_path, top=0)

    def whole(z):
        return {"startX": 0, "startY": 0, "endX": (2 << z) - 1, "endY": (1 << z) - 1}

    levels = [[whole(z)] for z in range(25)]
    if case == "overlapping":
        levels[24] *= 1000
    if case == "comb":
        levels[20] = [{**whole(20), "startX": 2 * k, "endX": 2 * k} for k in range(5000)]
        levels[20] += [{**whole(20), "startY": 2 * k, "endY": 2 * k} for k in range(5000)]
    writer.available = levels
    folder = writer.write_layer()
    code = HUGE.format(paths=[], name=f"QMESH:{folder}", options=["ZOOM=20"])
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, env=os.environ,
                          check=False)
    assert done.returncode == 0 and "done" in done.stdout, done.stderr
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before < 30
