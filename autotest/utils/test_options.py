# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What the options do to the tree."""

import gzip
import json

import numpy as np
import pytest

import dems
import harness
import promises
from oracle import terrain, tin
from oracle.nodes import Nodes, Source
from oracle.scheme import node_u
from oracle.tileset import TileSet


def build(dem, output, *options):
    harness.gdal2qmesh("-q", *options, dem, output).succeeded()
    return TileSet(output)


def mesh(tile):
    return [tile.u.tolist(), tile.v.tolist(), tile.q.tolist(), tile.triangles.tolist()]


def terrain_files(folder):
    return {k: v for k, v in harness.tree(folder).items() if k.endswith(".terrain")}


# ---- the tree ----


def test_xyz_turns_the_rows_over_and_nothing_else(tmp_path, dem):
    tms = build(dem("small"), tmp_path / "tms")
    xyz = build(dem("small"), tmp_path / "xyz", "--xyz")
    assert xyz.layer["scheme"] == "slippyMap"
    assert xyz.layer["available"] == tms.layer["available"]
    assert xyz.on_disk() == tms.on_disk()
    for name in tms.on_disk():
        assert xyz.path(*name).read_bytes() == tms.path(*name).read_bytes()
    assert xyz.path(3, 0, 0).name != tms.path(3, 0, 0).name


def test_compress_none_is_the_same_without_gzip(tmp_path, dem):
    zipped = build(dem("small"), tmp_path / "gzip")
    plain = build(dem("small"), tmp_path / "none", "--compress", "none")
    for name in zipped.on_disk():
        packed = zipped.path(*name).read_bytes()
        assert packed[:2] == b"\x1f\x8b" and packed[4:8] == bytes(4), "a time stamp"
        assert gzip.decompress(packed) == plain.path(*name).read_bytes()


def test_without_normals(tmp_path, dem):
    with_them = build(dem("small"), tmp_path / "with")
    without = build(dem("small"), tmp_path / "without", "--no-normals")
    assert "octvertexnormals" in with_them.layer["extensions"]
    assert without.layer.get("extensions", []) == []
    for name in with_them.on_disk():
        a, b = with_them.tile(*name), without.tile(*name)
        assert a.oct_normals() is not None and b.extensions == {}
        assert mesh(a) == mesh(b)


@pytest.mark.parametrize(
    "options, zooms",
    [(["-z", "2-5"], range(2, 6)), (["-z", "7"], [7]), (["-z", "8-"], range(8, 11)),
     (["--max-zoom", "3"], range(0, 4)), (["--min-zoom", "9"], range(9, 11)),
     (["-z", "0-12"], range(0, 13)), (["--min-zoom=4", "--max-zoom=4"], [4])],
    ids=str,
)
def test_zooms(tmp_path, dem, options, zooms):
    run = harness.gdal2qmesh(*options, dem("jacksboro"), tmp_path / "a").succeeded()
    tiles = TileSet(tmp_path / "a")
    assert sorted({z for z, _, _ in tiles.on_disk()}) == list(zooms)
    assert tiles.available() == tiles.on_disk()
    assert (tiles.layer["minzoom"], tiles.layer["maxzoom"]) == (min(zooms), max(zooms))
    assert ("warning" in run.err.lower() and "zoom 0" in run.err.lower()) == (min(zooms) > 0)
    promises.none(promises.valid(tiles) + promises.seamless(tiles)[0])


def test_the_native_zoom_of_the_shipped_dem(tile_set):
    """3 arc seconds: 180 / (256 * 2^z) degrees is not coarser from z = 10 on."""
    assert max(tile_set("jacksboro", "-q", "-p", "geodetic").levels()) == 10


def test_extent(tmp_path, dem):
    box = (10.1, 46.15, 10.3, 46.4)
    tiles = build(dem("void"), tmp_path / "a", "--te", *box, "--void-fill", "-5")
    nodes = Nodes(Source(dem("void")), tiles.scheme, 256, max(tiles.levels()), -5.0, box)
    promises.none(promises.bounded(tiles, nodes)[0])
    promises.none(promises.valid(tiles))
    for name in tiles.levels()[max(tiles.levels())]:
        west, south, east, north = tiles.scheme.box(*name)
        assert west < box[2] and east > box[0] and south < box[3] and north > box[1]
    assert tiles.layer["bounds"] == pytest.approx(box)


def test_extent_in_another_system(tmp_path, dem):
    """10.1 46.15 10.3 46.4 in the units of EPSG:3857 holds the same nodes."""
    r = 6378137.0
    west, east = (np.radians(v) * r for v in (10.1, 10.3))
    south, north = (np.log(np.tan(np.pi / 4 + np.radians(v) / 2)) * r for v in (46.15, 46.4))
    build(dem("void"), tmp_path / "a", "--te", 10.1, 46.15, 10.3, 46.4)
    build(dem("void"), tmp_path / "b", "--te", west, south, east, north, "--te-srs", "EPSG:3857")
    assert terrain_files(tmp_path / "a") == terrain_files(tmp_path / "b")


def test_cutline(tmp_path, dem):
    """Inside the triangle the DEM's heights, outside the void fill."""
    corners = [[10.01, 46.01], [10.04, 46.012], [10.025, 46.04], [10.01, 46.01]]
    polygon = {"type": "Feature", "properties": {},
               "geometry": {"type": "Polygon", "coordinates": [corners]}}
    (tmp_path / "cut.geojson").write_text(
        json.dumps({"type": "FeatureCollection", "features": [polygon]}))
    tiles = build(dem("small"), tmp_path / "a", "--cutline", tmp_path / "cut.geojson",
                  "--method", "delaunay", "--void-fill", "-100", "--max-error", "0.2")
    top = max(tiles.levels())
    nodes = Nodes(Source(dem("small")), tiles.scheme, 256, top)
    counts = [0, 0]
    for name in tiles.levels()[top]:
        tile = tiles.tile(*name)
        column, row = (np.round(p / 32767 * 256).astype(int) for p in (tile.u, tile.v))
        surface = np.full((257, 257), np.nan)
        surface[row, column] = tile.heights()
        west, south, east, north = tiles.scheme.box(*name)
        lon, lat = np.meshgrid(np.linspace(west, east, 257), np.linspace(south, north, 257))
        distance = np.full(lon.shape, np.inf)
        for (ax, ay), (bx, by) in zip(corners, corners[1:]):  # counter-clockwise
            side = ((bx - ax) * (lat - ay) - (by - ay) * (lon - ax)) / np.hypot(bx - ax, by - ay)
            distance = np.minimum(distance, side)
        height, _, _, _ = nodes.tile(*name)
        inside, outside = distance > 1e-9, distance < -1e-9
        assert np.abs(surface - height)[inside].max(initial=0) < 0.3  # border heights: to half a metre
        assert np.abs(surface + 100)[outside].max(initial=0) < 0.2
        counts[0] += inside.sum()
        counts[1] += outside.sum()
    assert min(counts) > 500


def test_tile_limits(tmp_path, dem, tile_set):
    whole = tile_set("jacksboro", "-q", "-p", "geodetic")
    top = max(whole.levels())
    columns = sorted({x for _, x, _ in whole.levels()[top]})
    rows = sorted({y for _, _, y in whole.levels()[top]})
    tiles = build(dem("jacksboro"), tmp_path / "a", "--min-x", columns[1], "--max-x", columns[1],
                  "--max-y", rows[0])
    assert set(tiles.levels()[top]) == {(top, columns[1], rows[0])}
    assert set(tiles.levels()[0]) == {(0, 0, 0), (0, 1, 0)}
    assert tiles.available() == tiles.on_disk()


def test_tiles_without_any_height_can_be_left_out(tmp_path):
    """Two islands of data in a void: with -x the tiles between them are not there."""
    ground = dems.hills(900, 900)
    ground[200:700, :] = -9999
    ground[:, 200:700] = -9999
    path = dems.write(tmp_path / "a.tif", ground, nodata=-9999)
    full = build(path, tmp_path / "full", "--tilesize", "64")
    sparse = build(path, tmp_path / "sparse", "-x", "--tilesize", "64")
    top = max(full.levels())
    nodes = Nodes(Source(path), full.scheme, 64, top)
    assert sparse.available() == sparse.on_disk() < full.on_disk()
    kept = sparse.on_disk()
    for name in full.on_disk():
        void = nodes.tile(*name)[3].all()
        if name not in kept:
            assert void, f"{name} has heights and is left out"
        else:
            assert full.path(*name).read_bytes() == sparse.path(*name).read_bytes()
            ancestor = any(n[0] > name[0] and (n[1] >> (n[0] - name[0]), n[2] >> (n[0] - name[0]))
                           == name[1:] for n in kept)
            assert not void or ancestor or name[0] == 0, f"{name} has no height and is there"
    assert len(full.on_disk()) - len(kept) > 20


# ---- meshes ----


def test_max_error_per_zoom(tmp_path, dem):
    tiles = build(dem("jacksboro"), tmp_path / "a", "--max-error", "0:5000,1-3:2000,4-:800/2^z")
    nodes = promises.nodes_of(dem("jacksboro"), "geodetic", 256, max(tiles.levels()))

    def limit(z):
        return 5000 if z == 0 else 2000 if z < 4 else 800 / 2.0**z

    promises.none(promises.bounded(tiles, nodes, limit)[0])
    for level in tiles.layer["qmesh"]["levels"]:
        assert level["maxError"] == pytest.approx(limit(level["zoom"]))


def test_screen_error(tmp_path, dem):
    tiles = build(dem("small"), tmp_path / "a", "--screen-error", "4")
    top = max(tiles.levels())
    for level in tiles.layer["qmesh"]["levels"]:
        z = level["zoom"]
        assert level["maxError"] == pytest.approx(tiles.scheme.default_max_error(z, top, 4))


def test_max_error_zero_ends_and_says_why(tmp_path, dem):
    """Rounding alone exceeds it: the report counts such tiles, and the mesh is as near as can be."""
    report = tmp_path / "report.json"
    tiles = build(dem("small"), tmp_path / "a", "--max-error", "0", "--tilesize", "64",
                  "--report", report)
    promises.none(promises.valid(tiles) + promises.seamless(tiles)[0])
    nodes = promises.nodes_of(dem("small"), "geodetic", 64, max(tiles.levels()))
    u = node_u(64)
    for name in tiles.available():
        height, v = nodes.tile(*name)[0], tiles.scheme.node_v(name[0], name[2], 64)
        surface = tin.evaluate(tiles.tile(*name), u, v)
        rounding = promises.rounding_bound(height, u, v, 2.0**-10).max()
        assert np.abs(surface - height).max() < 0.02 + 2 * rounding
    for level in json.loads(report.read_text())["zooms"]:
        assert (level["errorReached"] > 0) == (level["quantizationTiles"] > 0)


@pytest.mark.parametrize("max_error", ["0", "0.001", "0.1"])
def test_a_small_max_error_opens_no_seam(tmp_path, dem, max_error):
    """P1 before P2: where the format cannot hold the max error, neighbours still agree."""
    report = tmp_path / "report.json"
    tiles = build(dem("jacksboro"), tmp_path / "a", "--max-error", max_error, "--tilesize", "64",
                  "--report", report)
    faults, seams = promises.seamless(tiles)
    promises.none(faults)
    assert seams > 20
    assert json.loads(report.read_text())["total"]["coarseTiles"] == 0


def test_decimation_saves_triangles_within_the_same_error(tmp_path, dem):
    counts = {}
    for way in ("on", "off"):
        tiles = build(dem("jacksboro"), tmp_path / way, "--decimate", way)
        top = max(tiles.levels())
        nodes = promises.nodes_of(dem("jacksboro"), "geodetic", 256, top)
        promises.none(promises.bounded(tiles, nodes)[0])
        counts[way] = sum(len(tiles.tile(*t).triangles) for t in tiles.levels()[top])
    assert counts["on"] < 0.75 * counts["off"]


def test_delaunay_keeps_every_node(tmp_path, dem):
    tiles = build(dem("small"), tmp_path / "a", "--method", "delaunay", "--tilesize", "32")
    nodes = promises.nodes_of(dem("small"), "geodetic", 32, max(tiles.levels()))
    promises.none(promises.valid(tiles) + promises.seamless(tiles)[0])
    for name in tiles.available():
        tile = tiles.tile(*name)
        assert len(tile.u) == 33 * 33 and len(tile.triangles) == 2 * 32 * 32
    promises.none(promises.bounded(tiles, nodes, rounding=True)[0])


def test_a_tile_of_256_cells_has_32_bit_indices(tmp_path, dem):
    tiles = build(dem("small"), tmp_path / "a", "--method", "delaunay", "-z", "9-10")
    assert all(len(tiles.tile(*t).u) == 257 * 257 for t in tiles.available())
    promises.none(promises.valid(tiles))


RESAMPLINGS = ["near", "nearest", "bilinear", "cubic", "cubicspline", "lanczos", "average"]


@pytest.mark.parametrize("method", RESAMPLINGS)
@pytest.mark.parametrize("name", ["void", "rotated"])
def test_every_resampling(tmp_path, dem, name, method):
    """Bounded by the DEM's range (kernels that overshoot a little apart), valid and seamless."""
    tiles = build(dem(name), tmp_path / "a", "-r", method)
    promises.none(promises.valid(tiles) + promises.seamless(tiles)[0])
    heights = np.concatenate([tiles.tile(*t).heights() for t in tiles.available()])
    assert -120 < heights.min() and heights.max() < 2200


@pytest.mark.parametrize("method", ["nearest", "average", "cubic"])
def test_every_overview_resampling(tmp_path, dem, method):
    tiles = build(dem("void"), tmp_path / "a", "--overview-resampling", method)
    promises.none(promises.valid(tiles) + promises.seamless(tiles)[0])
    same = terrain_files(tmp_path / "a") == terrain_files(
        build(dem("void"), tmp_path / "b").folder)
    assert same == (method == "average")


def test_the_tiles_a_decoder_would_refuse(tmp_path):
    """The strict decoder is in use: it refuses a tile with one byte too many."""
    path = dems.write(tmp_path / "a.tif", dems.hills(30, 30))
    tiles = build(path, tmp_path / "a", "--compress", "none")
    data = tiles.path(0, 0, 0).read_bytes()
    terrain.decode(data)
    with pytest.raises(terrain.BadTile):
        terrain.decode(data + b"\1")
