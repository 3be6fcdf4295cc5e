# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The oracles themselves, against tiles made by hand and against closed formulas."""

import gzip
import struct

import numpy as np
import pytest
from osgeo import gdal, osr

from oracle import earth, terrain, tin, validity
from oracle.nodes import Nodes, Source
from oracle.scheme import QUANTIZED_MAX, Scheme, native_zoom, node_u

M = QUANTIZED_MAX


def zigzag(values):
    steps = np.diff(np.concatenate([[0], np.asarray(values, np.int64)]))
    return ((steps << 1) ^ (steps >> 63)).astype("<u2").tobytes()


def tile_bytes(u, v, q, triangles, edges=None, heights=(0.0, 100.0), box=(0, 0, 45, 45), tail=b""):
    """A tile's bytes; `triangles` must use the vertices in the order of their numbers."""
    u, v, q = (np.asarray(a, np.int64) for a in (u, v, q))
    if edges is None:
        edges = [np.flatnonzero(side) for side in (u == 0, v == 0, u == M, v == M)]
    lon, lat = box[0] + u / M * (box[2] - box[0]), box[1] + v / M * (box[3] - box[1])
    points = earth.ecef(lon, lat, heights[0] + q / M * (heights[1] - heights[0]))
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    radius = np.linalg.norm(points - centre, axis=1).max() * 1.001
    way = centre / earth.RADII
    way /= np.linalg.norm(way)
    horizon = way * (earth.horizon_magnitude(way, points / earth.RADII) or 500.0)
    data = struct.pack("<3d2f3dd3d", *centre, *heights, *centre, radius, *horizon)
    data += struct.pack("<I", len(u)) + zigzag(u) + zigzag(v) + zigzag(q)
    highest, codes = 0, []
    for index in np.ravel(triangles):
        codes.append(highest - index)
        highest += index == highest
    data += struct.pack(f"<I{len(codes)}H", len(codes) // 3, *codes)
    for side in edges:
        data += struct.pack(f"<I{len(side)}H", len(side), *side)
    return data + tail


# 1---2     the smallest tile: two triangles 0 3 1 and 1 3 2 (numbered as they are used)
# | \ |
# 0---3
SQUARE = dict(u=[0, M, 0, M], v=[0, 0, M, M], q=[0, M, M, 0], triangles=[[0, 1, 2], [2, 1, 3]])


def faults(**changes):
    return validity.mesh_faults(terrain.decode(tile_bytes(**{**SQUARE, **changes})))


def test_decodes_the_smallest_tile():
    tile = terrain.decode(tile_bytes(**SQUARE))
    assert tile.u.tolist() == SQUARE["u"] and tile.v.tolist() == SQUARE["v"]
    assert tile.triangles.tolist() == SQUARE["triangles"]
    assert tile.heights().tolist() == [0, 100, 100, 0]
    assert validity.mesh_faults(tile) == []
    assert validity.header_faults(tile, (0, 0, 45, 45)) == []
    assert validity.horizon_faults(tile, (0, 0, 45, 45)) == []


def test_refuses_every_shorter_file_and_trailing_bytes():
    data = tile_bytes(**SQUARE, tail=struct.pack("<BI", 1, 8) + bytes(8))
    terrain.decode(data)
    whole = len(tile_bytes(**SQUARE))
    for size in range(len(data)):
        if size != whole:  # where the extension begins the tile may end
            with pytest.raises(terrain.BadTile):
                terrain.decode(data[:size])
    with pytest.raises(terrain.BadTile):
        terrain.decode(data + b"\0")


def test_refuses_normals_of_a_wrong_length():
    with pytest.raises(terrain.BadTile, match="normals"):
        terrain.decode(tile_bytes(**SQUARE, tail=struct.pack("<BI", 1, 6) + bytes(6)))


def test_gzip_allows_nothing_after_the_member():
    assert terrain.gunzip(gzip.compress(b"abc")) == b"abc"
    for bad in (gzip.compress(b"abc") + b"x", gzip.compress(b"abc")[:-3], b"abc"):
        with pytest.raises(terrain.BadTile):
            terrain.gunzip(bad)


def test_names_each_fault_of_a_mesh():
    sides = [[0, 2], [0, 1], [1, 3], [2, 3]]
    assert "flipped" in str(faults(triangles=[[0, 1, 2], [1, 2, 3]]))
    assert "sum to" in str(faults(triangles=[[0, 1, 2]]))
    assert "not used" in str(faults(triangles=[[0, 1, 2]]))
    assert "twice in one direction" in str(faults(triangles=[[0, 1, 2], [2, 1, 3], [2, 1, 3]]))
    assert "one place" in str(faults(u=[0, M, 0, 0], v=[0, 0, M, M]))
    assert "west edge list" in str(faults(edges=[[0]] + sides[1:]))
    assert "north edge list" in str(faults(edges=sides[:3] + [[2, 3, 0]]))
    assert "twice" in str(faults(edges=sides[:1] + [[0, 1, 1]] + sides[2:]))
    # a vertex in the middle of the square's south side that one triangle passes by
    hole = dict(u=[0, M, 0, M, M // 2], v=[0, 0, M, M, 0], q=[0] * 5)
    assert faults(**hole, triangles=[[0, 1, 2], [2, 1, 3], [0, 4, 1]]) != []


def test_names_each_fault_of_a_header():
    good = tile_bytes(**SQUARE)
    box = (0, 0, 45, 45)

    def with_double(offset, value):
        return terrain.decode(good[:offset] + struct.pack("<d", value) + good[offset + 8 :])

    radius = terrain.decode(good).sphere_radius
    assert "outside the sphere" in str(validity.header_faults(with_double(56, radius * 0.9), box))
    assert "would do" in str(validity.header_faults(with_double(56, radius * 1.4), box))
    assert "not finite" in str(validity.header_faults(with_double(64, float("nan")), box))
    assert "outside the bounding" in str(validity.header_faults(with_double(0, 0.0), box))
    horizon = terrain.decode(good).horizon
    near = good[:64] + struct.pack("<3d", *(horizon * 0.99)) + good[88:]
    far = good[:64] + struct.pack("<3d", *(horizon * 1.2)) + good[88:]
    assert "is needed" in str(validity.horizon_faults(terrain.decode(near), box))
    assert "would do" in str(validity.horizon_faults(terrain.decode(far), box))


def test_a_viewer_finds_a_horizon_point_that_is_too_low():
    """The sampled viewers alone, without the formula, must notice it."""
    box = (10, 40, 10.5, 40.5)
    tile = terrain.decode(tile_bytes(**SQUARE, box=box))
    tile.horizon = tile.horizon * (1 - 2e-6)
    assert "sees a vertex" in str(validity.horizon_faults(tile, box, viewers=400))


def test_oct_decode_knows_the_axes_and_the_lower_half():
    codes = np.array([[255, 128], [128, 255], [128, 128], [0, 0], [255, 255]], np.uint8)
    n = earth.oct_decode(codes)
    assert np.allclose(n[:3], np.eye(3), atol=0.02)
    assert np.allclose(n[3:], [[0, 0, -1], [0, 0, -1]], atol=1e-6)


def test_ecef_of_known_places():
    p = earth.ecef(np.array([0.0, 90.0, 0.0]), np.array([0.0, 0.0, 90.0]), np.array([0.0, 10.0, 5.0]))
    assert np.allclose(p, [[6378137, 0, 0], [0, 6378147, 0], [0, 0, 6356757.3142451793]], atol=1e-6)


def test_the_surface_of_a_random_fan_is_its_plane():
    """All heights on one plane: whatever the triangles, every node gets the plane's height."""
    random = np.random.default_rng(5)
    ring = [(0, 0), (9000, 0), (M, 0), (M, 20001), (M, M), (13, M), (0, M), (0, 7)]
    middle = tuple(random.integers(1000, 30000, 2))
    u, v = np.array([middle] + ring).T
    q = (u + v) // 2
    fan = [[0, k, k % 8 + 1] for k in range(1, 9)]
    tile = terrain.Tile(None, 0.0, float(M), None, 0.0, None, u, v, q, np.array(fan), {})
    nodes = node_u(64)
    got = tin.evaluate(tile, nodes, nodes)
    assert np.abs(got - (nodes[None, :] + nodes[:, None]) / 2).max() < 0.51


def test_the_surface_is_linear_in_each_triangle_of_the_smallest_tile():
    tile = terrain.decode(tile_bytes(**SQUARE))
    nodes = node_u(8)
    x, y = np.meshgrid(nodes / M, nodes / M)
    expected = np.where(x + y <= 1, x + y, 2 - x - y) * 100
    assert np.allclose(tin.evaluate(tile, nodes, nodes), expected, atol=1e-9)


@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
def test_the_scheme(profile):
    scheme = Scheme(profile)
    assert scheme.box(0, 0, 0)[0] == -180
    assert np.isclose(scheme.box(0, 0, 0)[3], 90 if profile == "geodetic" else 85.0511287798066)
    assert np.isclose(scheme.fraction_y(scheme.latitude(3, 16)), 3 / 16)
    assert np.isclose(scheme.geometric_error(0), 77067.34 * (1 if profile == "geodetic" else 2))
    v = scheme.node_v(3, 1, 16)
    assert v[0] == 0 and v[-1] == M and (np.diff(v) > 0).all()


def test_native_zoom_of_three_arc_seconds():
    assert native_zoom(Scheme("geodetic"), 256, 3 / 3600) == 10


def make_ramp(path, epsg, origin, cell, shape, slope):
    rows, columns = shape
    x = origin[0] + (np.arange(columns) + 0.5) * cell
    y = origin[1] - (np.arange(rows) + 0.5) * cell
    data = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, 1, gdal.GDT_Float64)
    data.SetGeoTransform((origin[0], cell, 0, origin[1], 0, -cell))
    srs = osr.SpatialReference()
    srs.ImportFromEPSG(epsg)
    data.SetProjection(srs.ExportToWkt())
    data.GetRasterBand(1).WriteArray(slope[0] * x[None, :] + slope[1] * y[:, None])


@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
def test_nodes_of_a_geographic_ramp(tmp_path, profile):
    make_ramp(tmp_path / "r.tif", 4326, (10.0, 47.0), 0.01, (200, 150), (300.0, 500.0))
    nodes = Nodes(Source(tmp_path / "r.tif"), Scheme(profile), 64, 9, void_fill=-1.0)
    scheme = nodes.scheme
    x, y = int((10.7 + 180) / 360 * scheme.tiles_x(9)), int(scheme.fraction_y(46.0) * 512)
    height, tolerance, doubtful, void = nodes.tile(9, x, y)
    assert not doubtful.any() and tolerance.max() == 0 and not void.any()
    lon = scheme.longitude(x * 64 + np.arange(65), nodes.columns(9))
    lat = scheme.latitude(y * 64 + np.arange(65), nodes.last_row(9))
    assert np.allclose(height, 300 * lon[None, :] + 500 * lat[:, None], atol=1e-8)
    # Half the spacing on: the same nodes of the next coarser level keep their heights on a ramp
    # (in the geodetic profile; mercator's rows are not evenly spaced).
    if profile == "geodetic":
        coarse = nodes.tile(8, x // 2, y // 2)[0]
        part = coarse[(y % 2) * 32 :, (x % 2) * 32 :][:33, :33]
        assert np.allclose(part, height[::2, ::2], atol=1e-8)


def test_nodes_of_a_projected_source_are_exact(tmp_path):
    """The spline between exact positions is exact to far below the product's allowance."""
    make_ramp(tmp_path / "u.tif", 32633, (500000.0, 5200000.0), 100.0, (150, 200), (0.3, -0.2))
    source = Source(tmp_path / "u.tif")
    nodes = Nodes(source, Scheme("geodetic"), 64, 10)
    level = nodes.levels[10]
    forward = osr.CoordinateTransformation(source.wgs84, source.srs)
    rows, columns = np.nonzero(~np.isnan(level.height))
    for k in np.random.default_rng(3).integers(0, len(rows), 200):
        lon = nodes.scheme.longitude(level.i0 + columns[k], nodes.columns(10))
        lat = nodes.scheme.latitude(level.j0 + rows[k], nodes.last_row(10))
        x, y, _ = forward.TransformPoint(float(lon), float(lat))
        inside = 500050 < x < 519950 and 5185050 < y < 5199950
        if inside:
            assert abs(level.height[rows[k], columns[k]] - (0.3 * x - 0.2 * y)) < 1e-3


def test_voids_are_weighed_out(tmp_path):
    """A 3 x 3 lattice with a void corner: the coarse node is the mean over the other weights."""
    make_ramp(tmp_path / "r.tif", 4326, (0.0, 45.0), 0.5, (90, 90), (1.0, 0.0))
    data = gdal.Open(str(tmp_path / "r.tif"), gdal.GA_Update)
    values = data.ReadAsArray()
    values[:, 45:] = np.nan
    data.GetRasterBand(1).WriteArray(values)
    data = None
    nodes = Nodes(Source(tmp_path / "r.tif"), Scheme("geodetic"), 64, 4, void_fill=7.0)
    fine, coarse = nodes.levels[4], nodes.levels[3]
    j, i = np.argwhere(~np.isnan(coarse.height) & ~np.isnan(np.roll(coarse.height, 1, 1)))[40]
    a, b = 2 * (coarse.j0 + j) - fine.j0, 2 * (coarse.i0 + i) - fine.i0
    stencil = fine.height[a - 1 : a + 2, b - 1 : b + 2]
    weights = np.outer([1, 2, 1], [1, 2, 1]) * ~np.isnan(stencil)
    assert np.isclose(coarse.height[j, i], np.nansum(weights * stencil) / weights.sum())
    filled = nodes.tile(0, 1, 0)
    assert (filled[0][filled[3]] == 7.0).all() and filled[3].any() and not filled[3].all()
