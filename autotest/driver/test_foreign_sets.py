# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Sets by other programs: absent keys, old habits, other places, servers."""

import json
import struct

import numpy as np
import pytest
from osgeo import gdal

from formula_sets import Writer, plane, pyramid
from looking import NODATA, centres, raster, vector
from made import messages
from oracle import terrain
from web import serving


def assert_plane(dataset, tolerance=0.2):
    band = dataset.GetRasterBand(1)
    mercator = dataset.GetSpatialRef().GetAuthorityCode(None) == "3857"
    lon, lat = centres(band, dataset.GetGeoTransform(), not mercator)
    assert np.abs(band.ReadAsArray() - plane(lon[None, :], lat[:, None])).max() < tolerance


def without_normals(tile):
    """The bytes of a tile up to its extensions."""
    vertices = len(terrain.decode(tile).u)
    return tile[: len(tile) - 5 - 2 * vertices]


# ---- layer.json -------------------------------------------------------------------------------------


@pytest.mark.parametrize("compress", [True, False])
@pytest.mark.parametrize("from_north", [True, False])
@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
def test_both_schemes_and_profiles_compressed_or_not(tmp_path, profile, from_north, compress):
    folder = pyramid(tmp_path, profile, 2, from_north=from_north, compress=compress).write_layer()
    assert_plane(raster(folder))
    dataset = vector(folder)
    for feature in dataset.GetLayer("vertices"):
        lon, lat, height = feature.geometry().GetPoint()
        assert height == pytest.approx(plane(lon, lat), abs=0.1)


def test_absent_keys(tmp_path):
    folder = pyramid(tmp_path, top=1).write_layer(projection=None, scheme=None, version=None)
    dataset = raster(folder)
    assert_plane(dataset)
    assert dataset.GetRasterBand(1).GetBlockSize() == [256, 256]
    for key in ("METHOD", "MAX_ERROR", "VERSION", "NAME", "EXTENSIONS"):
        assert dataset.GetMetadataItem(key) is None
    layer = vector(folder)
    assert layer.GetLayer("tiles").GetNextFeature()["error"] is None


def test_without_a_list_of_tiles_the_folder_tells(tmp_path):
    writer = pyramid(tmp_path, top=1)
    writer.write_tile(3, 5, 4)
    dataset = raster(writer.write_layer(available=None))
    assert (dataset.RasterXSize, dataset.GetMetadataItem("ZOOM")) == (256, "3")
    assert_plane(dataset)


def test_ranges_that_overlap_count_once(tmp_path):
    writer = pyramid(tmp_path, top=1)
    writer.available[1] += [{"startX": 1, "startY": 0, "endX": 2, "endY": 1}]
    folder = writer.write_layer()
    assert_plane(raster(folder))
    layer = vector(folder)
    assert layer.GetLayer("tiles").GetFeatureCount() == 8
    assert len(list(layer.GetLayer("tiles"))) == 8


@pytest.mark.parametrize(
    "pattern, place",
    [("tiles/{z}/{x}/{y}.mesh?v={version}", "tiles/{z}/{x}/{y}.mesh"), ("./{version}/{z}-{x}-{y}", "1.0.0/{z}-{x}-{y}"),
     ("/tilesets/world/{z}/{x}/{y}.terrain", "{z}/{x}/{y}.terrain")],
)
def test_other_patterns_of_addresses(tmp_path, pattern, place):
    source = pyramid(tmp_path / "source", top=1)
    folder = tmp_path / "set"
    for file in (tmp_path / "source").rglob("*.terrain"):
        z, x, y = *file.parts[-3:-1], file.stem
        target = folder / place.format(z=z, x=x, y=y)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(file.read_bytes())
    source.folder = folder
    assert_plane(raster(source.write_layer(tiles=[pattern, "http://127.0.0.1:1/never"])))


def test_availability_in_the_tiles(tmp_path):
    """metadataAvailability: the roots list levels 1 and 2; level 3 is found by trying."""
    writer = Writer(tmp_path)
    for z, (x0, y0, x1, y1) in enumerate([(0, 0, 1, 0), (2, 0, 2, 1), (4, 0, 5, 1), (8, 0, 8, 0)]):
        for x in range(x0, x1 + 1):
            for y in range(y0, y1 + 1):
                tile = without_normals(writer.tile(z, x, y))
                if z == 0:
                    text = json.dumps({"available": [
                        [{"startX": 2, "startY": 0, "endX": 2, "endY": 1}],
                        [{"startX": 4, "startY": 0, "endX": 5, "endY": 1}]] if x else [[], []]}).encode()
                    tile += struct.pack("<BI", 4, 4 + len(text)) + struct.pack("<I", len(text)) + text
                writer.write_tile(z, x, y, tile)
    folder = writer.write_layer(available=None, metadataAvailability=2, maxzoom=3, extensions=["metadata"],
                                bounds=[0, -90, 22.5, -67.5])
    dataset = raster(folder)
    assert dataset.GetMetadataItem("ZOOM") == "2" and dataset.RasterXSize == 512
    assert_plane(dataset)
    deepest = raster(folder, ZOOM=3)
    assert (deepest.RasterXSize, deepest.RasterYSize) == (256, 256)
    assert_plane(deepest)
    with pytest.raises(RuntimeError, match="no tiles of zoom 4"):
        raster(folder, ZOOM=4)


@pytest.mark.parametrize("text, words", [
    ("", "not JSON"), ("{", "not JSON"), ("[]", "not a JSON object"), ("{}", "format"),
    ('{"format":"heightmap-1.0","tiles":["a"]}', "heightmap-1.0"),
    ('{"format":"quantized-mesh-1.0"}', "tiles"),
    ('{"format":"quantized-mesh-1.0","tiles":["a"],"available":[]}', "lists no tiles"),
])
def test_a_layer_json_that_cannot_be_used(tmp_path, text, words):
    (tmp_path / "layer.json").write_text(text)
    with pytest.raises(RuntimeError, match=words):
        raster(f"QMESH:{tmp_path}")


def test_a_place_without_a_set():
    for name in ("QMESH:/no/such/place", "QMESH:", "QMESH:/vsimem/nothing"):
        with pytest.raises(RuntimeError, match="layer.json"):
            raster(name)


# ---- Tiles ------------------------------------------------------------------------------------------


def test_wide_indices(tmp_path):
    """257 x 257 vertices: indices of 32 bits."""
    writer = Writer(tmp_path, cells=256)
    writer.write_level(1, 2, 1, 2, 1)
    writer.available[0] = [{"startX": 0, "startY": 0, "endX": 1, "endY": 0}]
    dataset = raster(writer.write_layer())
    assert_plane(dataset)
    layer = vector(tmp_path)
    assert layer.GetLayer("tiles").GetNextFeature()["vertices"] == 257 * 257


def test_the_old_name_of_normals_means_the_old_byte_order(tmp_path):
    writer = Writer(tmp_path)
    for x in (0, 1):
        plain = without_normals(writer.tile(0, x, 0))
        normals = writer.tile(0, x, 0)[len(plain) + 5 :]
        writer.write_tile(0, x, 0, plain + struct.pack(">BI", 1, len(normals)) + normals)
    writer.available = [[{"startX": 0, "startY": 0, "endX": 1, "endY": 0}]]
    assert_plane(raster(writer.write_layer(extensions=["vertexnormals"])))
    writer.write_layer(extensions=["octvertexnormals"])
    with pytest.raises(RuntimeError, match="extension"):
        raster(tmp_path).ReadAsArray()


def test_unknown_extensions_are_passed_over(tmp_path):
    writer = Writer(tmp_path)
    for x in (0, 1):
        writer.write_tile(0, x, 0, writer.tile(0, x, 0) + struct.pack("<BI", 77, 3) + b"abc")
    writer.available = [[{"startX": 0, "startY": 0, "endX": 1, "endY": 0}]]
    assert_plane(raster(writer.write_layer()))


def test_a_tile_with_a_hole_has_nodata_there(tmp_path):
    """Half of the first cell's triangles is missing; another turns the wrong way."""
    writer = Writer(tmp_path, cells=2)
    tile = bytearray(without_normals(writer.tile(0, 0, 0)))
    start = 92 + 9 * 6 + 4  # of the indices
    codes = np.frombuffer(bytes(tile[start : start + 48]), "<u2").copy()
    mesh = terrain.decode(bytes(tile))
    missing = mesh.triangles[-1]
    tile[start - 4 : start] = struct.pack("<I", 7)
    del tile[start + 42 : start + 48]
    assert len(codes) == 24
    for x in (0, 1):
        writer.write_tile(0, x, 0, bytes(tile))
    writer.available = [[{"startX": 0, "startY": 0, "endX": 1, "endY": 0}]]
    dataset = raster(writer.write_layer())
    values = dataset.ReadAsArray(0, 0, 256, 256)
    share = (values == NODATA).mean()
    assert share == pytest.approx(1 / 8, abs=0.01)
    u, v = mesh.u[missing].mean(), mesh.v[missing].mean()
    assert values[255 - int(v * 256 / 32767), int(u * 256 / 32767)] == NODATA


# ---- Servers ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("encoding", [True, False])
@pytest.mark.parametrize("compress", [True, False])
def test_a_set_on_a_server(tmp_path, encoding, compress):
    pyramid(tmp_path / "a" / "set", top=2, compress=compress).write_layer()
    with serving(tmp_path, encoding) as (address, requests):
        gdal.VSICurlClearCache()
        for name in (f"QMESH:{address}/a/set", f"QMESH:{address}/a/set?key=7", f"QMESH:{address}/a/set/layer.json?key=7",
                     f"/vsicurl/{address}/a/set/layer.json"):
            assert_plane(raster(name))
        dataset = raster(f"QMESH:{address}/a/set")
        requests.clear()
        gdal.VSICurlClearCache()
        dataset.ReadAsArray(256, 256, 256, 256)
        assert {line.split("?")[0] for line in requests} == {"GET /a/set/2/1/2.terrain"}
        assert "?v=1.0.0" in requests[0] and len(requests) <= 2


def test_the_query_of_layer_json_stays(tmp_path):
    pyramid(tmp_path, top=1).write_layer()
    with serving(tmp_path) as (address, requests):
        gdal.VSICurlClearCache()
        raster(f"QMESH:{address}/layer.json?key=7").ReadAsArray(0, 0, 256, 256)
        assert [line for line in requests if line.startswith("GET /1/0/1.terrain?v=1.0.0&key=7")]


def test_a_missing_tile_and_an_error_of_the_server_are_told_apart(tmp_path):
    pyramid(tmp_path, top=1).write_layer()
    (tmp_path / "1" / "0" / "1.terrain").unlink()
    with serving(tmp_path, broken={"1/1/1.terrain"}) as (address, _):
        gdal.VSICurlClearCache()
        dataset = raster(f"QMESH:{address}")
        with messages() as said:
            assert (dataset.ReadAsArray(0, 0, 256, 256) == NODATA).all()
        assert [kind for kind, _, _ in said] == [gdal.CE_Warning]
        with pytest.raises(RuntimeError, match="1/1/1.terrain"):
            dataset.ReadAsArray(256, 0, 256, 256)
