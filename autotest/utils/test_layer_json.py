# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""layer.json: every key CesiumJS reads, and `available` exactly as the files lie on the disk."""

import pytest

import dems
import harness
from oracle.tileset import TileSet
from osgeo import gdal

NAMES = [n for n in dems.DEMS if n not in dems.REAL or n in ("global_etopo", "bigtujunga")]


@pytest.mark.parametrize("name", NAMES)
def test_available_is_what_is_there(tile_set, name):
    tiles = tile_set(name, "-q", "-p", "geodetic")
    layer = tiles.layer
    assert tiles.available() == tiles.on_disk()
    assert layer["minzoom"] == 0 and layer["maxzoom"] == len(layer["available"]) - 1
    for z, ranges in enumerate(layer["available"]):
        assert ranges, f"level {z} lists nothing"
        for r in ranges:
            assert set(r) == {"startX", "startY", "endX", "endY"}
            assert 0 <= r["startX"] <= r["endX"] < tiles.scheme.tiles_x(z)
            assert 0 <= r["startY"] <= r["endY"] < tiles.scheme.tiles_y(z)
    assert set(tiles.levels()[0]) == {(0, x, 0) for x in range(tiles.scheme.tiles_x(0))}
    for z, x, y in tiles.available():
        assert z == 0 or (z - 1, x // 2, y // 2) in tiles.available(), f"{z}/{x}/{y} is an orphan"


@pytest.mark.parametrize("profile, crs", [("geodetic", "EPSG:4326"), ("mercator", "EPSG:3857")])
def test_every_key_a_client_reads(tile_set, profile, crs):
    layer = tile_set("jacksboro", "-q", "-p", profile).layer
    assert layer["format"] == "quantized-mesh-1.0"
    assert layer["projection"] == crs
    assert layer["scheme"] == "tms" and "schema" not in layer
    assert layer["tiles"] == ["{z}/{x}/{y}.terrain?v={version}"]
    assert layer["version"] and isinstance(layer["version"], str)
    assert layer["extensions"] == ["octvertexnormals"]
    assert "metadataAvailability" not in layer or layer["metadataAvailability"] == 0
    assert layer["tilejson"]
    assert layer["name"]
    edges = (-84.41375, 36.1595833333, -84.0779166667, 36.44625)
    assert layer["bounds"] == pytest.approx(edges, abs=1e-6)


def test_only_tiles_that_meet_the_data_are_made(tile_set, dem):
    """The shipped DEM, geographic, so that its box is exact: at the last zoom those whose square
    shares area with it; above, their ancestors and the roots."""
    tiles = tile_set("jacksboro", "-q", "-p", "geodetic")
    data = gdal.Open(str(dem("jacksboro")))
    t = data.GetGeoTransform()
    west, north = t[0], t[3]
    east, south = west + t[1] * data.RasterXSize, north + t[5] * data.RasterYSize
    top = max(tiles.levels())
    wanted = set()
    for x in range(tiles.scheme.tiles_x(top)):
        box = tiles.scheme.box(top, x, 0)
        if box[2] <= west or box[0] >= east:
            continue
        for y in range(tiles.scheme.tiles_y(top)):
            box = tiles.scheme.box(top, x, y)
            if box[3] > south and box[1] < north:
                wanted.add((top, x, y))
    assert set(tiles.levels()[top]) == wanted
    for z in range(top - 1, 0, -1):
        wanted = {(z, x // 2, y // 2) for _, x, y in wanted}
        assert set(tiles.levels()[z]) == wanted


def test_title_and_copyright(tmp_path, dem):
    harness.gdal2qmesh("-q", "-t", 'Alps "high" äöü', "-c", "© Survey <2026>", dem("small"),
                       tmp_path / "a").succeeded()
    layer = TileSet(tmp_path / "a").layer
    assert layer["name"] == 'Alps "high" äöü'
    assert layer["attribution"] == "© Survey <2026>"


def test_the_version_changes_with_the_content_alone(tmp_path, dem):
    versions = []
    for output, options in (("a", ()), ("b", ("-j", "1")), ("c", ("--max-error", "100"))):
        harness.gdal2qmesh("-q", *options, dem("small"), tmp_path / output).succeeded()
        versions.append(TileSet(tmp_path / output).layer["version"])
    assert versions[0] == versions[1] != versions[2]


def descendants(tiles):
    """All tiles a client finds that reads layer.json's `available` and the metadata of the tiles at
    z % N == 0."""
    every = tiles.layer["metadataAvailability"]
    known = set(tiles.available()) | set(tiles.levels()[0])
    queue = sorted(known)
    while queue:
        name = queue.pop()
        if name[0] % every:
            continue
        metadata = tiles.tile(*name).metadata()
        for depth, ranges in enumerate(metadata["available"]):
            z = name[0] + 1 + depth
            for r in ranges:
                for x in range(r["startX"], r["endX"] + 1):
                    for y in range(r["startY"], r["endY"] + 1):
                        assert (x >> (depth + 1), y >> (depth + 1)) == name[1:], "not a descendant"
                        if (z, x, y) not in known:
                            known.add((z, x, y))
                            queue.append((z, x, y))
    return known


@pytest.mark.parametrize("every", [1, 4, 10])
@pytest.mark.parametrize("name", ["jacksboro", "antimeridian"])
def test_metadata_lists_the_descendants(tile_set, name, every):
    tiles = tile_set(name, "-q", "--metadata", every)
    plain = tile_set(name, "-q", "-p", "geodetic")
    assert tiles.layer["metadataAvailability"] == every
    assert "metadata" in tiles.layer["extensions"]
    assert tiles.on_disk() == plain.on_disk()
    assert descendants(tiles) == plain.on_disk()
    top = plain.layer["maxzoom"]
    for t in tiles.on_disk():
        metadata = tiles.tile(*t).metadata()
        assert (metadata is not None) == (t[0] % every == 0)
        if metadata is not None:
            below = {n for n in plain.on_disk() if n[0] > t[0]
                     and (n[1] >> (n[0] - t[0]), n[2] >> (n[0] - t[0])) == t[1:]}
            within = {n for n in below if n[0] <= t[0] + every}
            listed = {(t[0] + 1 + d, x, y) for d, ranges in enumerate(metadata["available"])
                      for r in ranges for x in range(r["startX"], r["endX"] + 1)
                      for y in range(r["startY"], r["endY"] + 1)}
            assert within <= listed <= below, f"{t} lists wrongly (top {top})"


def test_a_set_without_metadata_has_none_in_its_tiles(tile_set):
    tiles = tile_set("jacksboro", "-q", "-p", "geodetic")
    assert all(tiles.tile(*t).metadata() is None for t in tiles.on_disk())
