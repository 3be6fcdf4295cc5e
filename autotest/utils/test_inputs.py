# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Inputs that are unusual and must work: each is compared with the oracle or with its plain twin."""

import zipfile

import numpy as np
import pytest
from osgeo import gdal

import dems
import harness
import promises
from oracle import tin
from oracle.nodes import Nodes, Source
from oracle.scheme import node_u
from oracle.tileset import TileSet


def build(dem, output, *options):
    run = harness.gdal2qmesh("-q", *options, dem, output).succeeded()
    return TileSet(output), run


def check(tiles, nodes=None):
    promises.none(promises.valid(tiles))
    promises.none(promises.seamless(tiles)[0])
    if nodes is not None:
        promises.none(promises.bounded(tiles, nodes)[0])


def oracle(tiles, path, **options):
    keys = {k: options.pop(k) for k in ("void_fill", "box", "node_heights") if k in options}
    return Nodes(Source(path, **options), tiles.scheme, 256, max(tiles.levels()), **keys)


def terrain_files(folder):
    return {k: v for k, v in harness.tree(folder).items() if k.endswith(".terrain")}


def test_nan_and_infinite_cells_are_voids(tmp_path):
    """The same tiles as with a declared nodata value in their place."""
    ground = dems.hills(80, 90)
    holes = np.random.default_rng(4).random(ground.shape) < 0.1
    holes[20:40, 30:50] = True
    declared, odd = ground.copy(), ground.copy()
    declared[holes] = -9999
    odd[holes] = np.resize([np.nan, np.inf, -np.inf], int(holes.sum()))
    a = dems.write(tmp_path / "a.tif", declared, nodata=-9999)
    b = dems.write(tmp_path / "b.tif", odd)
    tiles, _ = build(a, tmp_path / "a")
    build(b, tmp_path / "b")
    assert terrain_files(tmp_path / "a") == terrain_files(tmp_path / "b")
    check(tiles, oracle(tiles, a))
    low = min(tiles.tile(*t).heights().min() for t in tiles.available())
    assert low > -1, "a nodata value became a height"


@pytest.mark.parametrize("filler", [-3.4028234663852886e38, 3.4028234663852886e38, -1e38, 9.96921e36, 1e20])
def test_numbers_that_no_height_can_have_are_voids(tmp_path, filler):
    """Fill values that nobody declared; the same tiles as with NaN in their place."""
    ground = dems.hills(80, 90)
    declared, odd = ground.copy(), ground.copy()
    declared[20:40, 30:50] = np.nan
    odd[20:40, 30:50] = filler
    a = dems.write(tmp_path / "a.tif", declared)
    b = dems.write(tmp_path / "b.tif", odd)
    c = dems.write(tmp_path / "c.tif", odd.astype(np.float64), scale=2.0, offset=0.0)
    build(a, tmp_path / "a", "-z", "0-8")
    build(b, tmp_path / "b", "-z", "0-8")
    assert terrain_files(tmp_path / "a") == terrain_files(tmp_path / "b")
    tiles, _ = build(c, tmp_path / "c", "-z", "0-8")
    check(tiles)
    assert max(tiles.tile(*t).heights().max() for t in tiles.available()) < 2000


def test_nodata_given_by_hand(tmp_path):
    ground = dems.hills(60, 60)
    ground[10:30, 10:20] = -777
    path = dems.write(tmp_path / "a.tif", ground)
    tiles, _ = build(path, tmp_path / "a", "-a", "-777", "--void-fill", "50")
    check(tiles, oracle(tiles, path, nodata=-777, void_fill=50.0))


def test_nodata_that_float32_cannot_hold(tmp_path):
    """-3.4028234663852886e+38 and the like, written as text by many programs."""
    ground = dems.hills(60, 60)
    ground[10:30, 10:20] = -3.4028234663852886e38
    path = dems.write(tmp_path / "a.tif", ground, nodata=-3.4028235e38)
    tiles, _ = build(path, tmp_path / "a")
    assert max(abs(tiles.tile(*t).heights()).max() for t in tiles.available()) < 1000


def test_a_mask_band_is_honoured(tmp_path):
    ground = dems.hills(60, 60)
    path = dems.write(tmp_path / "a.tif", ground)
    data = gdal.Open(str(path), gdal.GA_Update)
    data.CreateMaskBand(gdal.GMF_PER_DATASET)  # a file beside it
    mask = np.full((60, 60), 255, np.uint8)
    mask[:, :25] = 0
    data.GetRasterBand(1).GetMaskBand().WriteArray(mask)
    data = None
    ground[:, :25] = -9999
    twin = dems.write(tmp_path / "b.tif", ground, nodata=-9999)
    build(path, tmp_path / "a")
    build(twin, tmp_path / "b")
    assert terrain_files(tmp_path / "a") == terrain_files(tmp_path / "b")


def test_a_paletted_band_counts_as_it_stands_with_a_warning(tmp_path):
    values = (dems.hills(60, 60, 0, 250)).astype(np.uint8)
    plain = dems.write(tmp_path / "plain.tif", values)
    paletted = dems.write(tmp_path / "paletted.tif", values, driver="GTiff")
    data = gdal.Open(str(paletted), gdal.GA_Update)
    table = gdal.ColorTable()
    for k in range(256):
        table.SetColorEntry(k, (k, 255 - k, 0))
    data.GetRasterBand(1).SetColorTable(table)
    data = None
    build(plain, tmp_path / "plain")
    run = harness.gdal2qmesh(paletted, tmp_path / "paletted").succeeded()
    assert "warning" in run.err.lower() and "palette" in run.err.lower()
    assert terrain_files(tmp_path / "plain") == terrain_files(tmp_path / "paletted")


def test_scale_and_offset(tmp_path):
    values = (dems.hills(60, 60, 0, 9000)).astype(np.int16)
    path = dems.write(tmp_path / "a.tif", values, scale=0.1, offset=-250.0, nodata=-32768)
    tiles, _ = build(path, tmp_path / "a")
    nodes = oracle(tiles, path)
    assert np.nanmax(nodes.levels[max(tiles.levels())].height) < 651
    check(tiles, nodes)


@pytest.mark.parametrize(
    "unit, metres",
    [("ft", 0.3048), ("foot", 0.3048), ("US survey foot", 1200 / 3937), ("m", 1.0), ("metre", 1.0)],
)
def test_units(tmp_path, unit, metres):
    path = dems.write(tmp_path / "a.tif", dems.hills(60, 60), unit=unit)
    tiles, _ = build(path, tmp_path / "a")
    check(tiles, oracle(tiles, path, pixels=lambda v: v * metres))


def test_an_unknown_unit_is_warned_of(tmp_path):
    path = dems.write(tmp_path / "a.tif", dems.hills(30, 30), unit="cubit")
    run = harness.gdal2qmesh(path, tmp_path / "a").succeeded()
    assert "cubit" in run.err


def test_a_vrt_and_a_zip(tmp_path, dem):
    source = dem("small")
    gdal.Translate(str(tmp_path / "small.vrt"), str(source), format="VRT")
    with zipfile.ZipFile(tmp_path / "small.zip", "w") as archive:
        archive.write(source, "inside/small.tif")
    build(source, tmp_path / "plain")
    build(tmp_path / "small.vrt", tmp_path / "vrt")
    build(f"/vsizip/{tmp_path}/small.zip/inside/small.tif", tmp_path / "zip")
    expected = terrain_files(tmp_path / "plain")
    assert terrain_files(tmp_path / "vrt") == expected
    assert terrain_files(tmp_path / "zip") == expected


@pytest.mark.parametrize("dtype", ["Byte", "UInt16", "Int32", "UInt32", "Float64"])
def test_every_real_type_gives_the_same_terrain(tmp_path, dtype):
    values = np.round(dems.hills(40, 40, 0, 255))
    plain = dems.write(tmp_path / "plain.tif", values.astype(np.float32))
    gdal.Translate(str(tmp_path / "other.tif"), str(plain),
                   outputType=gdal.GetDataTypeByName(dtype))
    build(plain, tmp_path / "plain")
    build(tmp_path / "other.tif", tmp_path / "other")
    assert terrain_files(tmp_path / "plain") == terrain_files(tmp_path / "other")


def test_one_pixel(tmp_path):
    path = dems.write(tmp_path / "a.tif", np.float32([[321.0]]), (10.0, 0.25, 0, 47.0, 0, -0.25))
    tiles, _ = build(path, tmp_path / "a", "--max-error", "1")
    promises.none(promises.valid(tiles) + promises.bounded(tiles, oracle(tiles, path), lambda z: 1)[0])
    heights = np.concatenate([tiles.tile(*t).heights() for t in tiles.levels()[max(tiles.levels())]])
    assert abs(heights.max() - 321) < 0.01


@pytest.mark.parametrize("shape", [(2, 100000), (100000, 2)], ids=["wide", "tall"])
def test_a_strip_of_two_by_a_hundred_thousand(tmp_path, shape):
    rows, columns = shape
    long = np.arange(max(shape)) * 0.01
    values = np.broadcast_to(long if columns > rows else long[:, None], shape).astype(np.float32)
    path = dems.write(tmp_path / "a.tif", values, (-50.0, 0.001, 0, 50.0, 0, -0.001))
    tiles, _ = build(path, tmp_path / "a", "--tilesize", "256")
    assert len(tiles.available()) > 500
    promises.none(promises.seamless(tiles)[0])
    check(tiles, oracle(tiles, path) if harness.FULL else None)


@pytest.mark.parametrize("zooms", [(), ("-z", "0-6")], ids=["native", "coarse"])
def test_a_dem_smaller_than_a_node_cell(tmp_path, zooms):
    """3 x 3 cells of 10 m; at zoom 6 the nodes are 1.2 km apart and may all miss it."""
    path = dems.write(tmp_path / "a.tif", dems.hills(3, 3), (500003, 10, 0, 5200007, 0, -10),
                      "EPSG:32633")
    tiles, _ = build(path, tmp_path / "a", *zooms)
    check(tiles)
    assert len(tiles.available()) < 40


def test_longitudes_from_0_to_360(tmp_path, dem):
    """The whole Earth cut at Greenwich instead of the antimeridian: the same terrain."""
    usual = gdal.Open(str(dem("global")))
    values = usual.ReadAsArray()
    turned = np.roll(values, values.shape[1] // 2, axis=1)
    t = usual.GetGeoTransform()
    path = dems.write(tmp_path / "a.tif", turned, (0.0, *t[1:]))
    build(path, tmp_path / "turned", "-z", "0-2")
    build(dem("global"), tmp_path / "usual", "-z", "0-2")
    assert terrain_files(tmp_path / "turned") == terrain_files(tmp_path / "usual")


def test_a_south_up_raster(tmp_path):
    ground = dems.hills(50, 60)
    up = dems.write(tmp_path / "up.tif", ground, (10, 0.001, 0, 47, 0, -0.001))
    down = dems.write(tmp_path / "down.tif", ground[::-1], (10, 0.001, 0, 46.95, 0, 0.001))
    build(up, tmp_path / "up")
    build(down, tmp_path / "down")
    tiles = TileSet(tmp_path / "down")
    check(tiles, oracle(tiles, down))


def test_another_band_and_an_open_option(tmp_path):
    first, second = dems.hills(40, 40, seed=1), dems.hills(40, 40, seed=2)
    path = dems.write(tmp_path / "two.tif", second)
    both = gdal.BuildVRT(str(tmp_path / "two.vrt"),
                         [str(dems.write(tmp_path / "one.tif", first)), str(path)], separate=True)
    both = None
    build(path, tmp_path / "plain")
    build(tmp_path / "two.vrt", tmp_path / "band", "-b", "2")
    build(path, tmp_path / "opened", "--oo", "NUM_THREADS=1", "--if", "GTiff")
    assert terrain_files(tmp_path / "plain") == terrain_files(tmp_path / "band")
    assert terrain_files(tmp_path / "plain") == terrain_files(tmp_path / "opened")


def test_depths_that_count_downwards(tmp_path):
    sea = dems.hills(60, 60, -3000, 200)
    up = dems.write(tmp_path / "up.tif", sea)
    down = dems.write(tmp_path / "down.tif", -sea)
    build(up, tmp_path / "up")
    tiles, _ = build(down, tmp_path / "down", "--bathymetry")
    assert terrain_files(tmp_path / "up") == terrain_files(tmp_path / "down")
    check(tiles, oracle(tiles, up))


def test_clips_and_scales(tmp_path):
    path = dems.write(tmp_path / "a.tif", dems.hills(60, 60, -500, 500))
    tiles, _ = build(path, tmp_path / "a", "--clip-low", "-200", "--clip-high", "800",
                     "--scale-above", "2", "--scale-below", "0.5")

    def expected(heights):
        return np.clip(np.where(heights > 0, heights * 2, heights * 0.5), -200, 800)

    check(tiles, oracle(tiles, path, node_heights=expected))


def test_voids_are_interpolated(tmp_path):
    """Nodes with data keep their heights; the others stay within those of the rim and are smooth."""
    ground = dems.hills(120, 120, 500, 600)
    ground[40:80, 30:90] = -9999
    path = dems.write(tmp_path / "a.tif", ground, nodata=-9999)
    tiles, _ = build(path, tmp_path / "a", "--void-fill", "interpolate", "--max-error", "0.3")
    check(tiles)
    nodes = oracle(tiles, path)
    top = max(tiles.levels())
    level = nodes.levels[top]
    u = node_u(256)
    for name in tiles.levels()[top]:
        v = tiles.scheme.node_v(top, name[2], 256)
        surface = tin.evaluate(tiles.tile(*name), u, v)
        height, _, _, void = nodes.tile(*name)
        assert np.abs(surface - height)[~void].max(initial=0) <= 0.3 + 1e-3
        i = (name[1] * 256 + np.arange(257) - level.i0)[None, :] + 0 * void
        j = (name[2] * 256 + np.arange(257) - level.j0)[:, None] + 0 * void
        rows, columns = level.height.shape
        inside = void & (i > 4) & (i < columns - 5) & (j > 4) & (j < rows - 5)
        if inside.any():
            assert surface[inside].min() > 490 and surface[inside].max() < 610
