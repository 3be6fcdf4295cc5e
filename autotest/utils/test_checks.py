# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The checks of whole sets themselves: they pass a set of another encoder where it is right, and find
what is wrong with it."""

import numpy as np
import pytest
from make_dem import make_dem
from tiny_set import write_set

import promises
from oracle.nodes import Nodes, Source
from oracle.scheme import QUANTIZED_MAX, Scheme, node_u
from oracle.terrain import Tile
from oracle.tileset import TileSet, seam_faults


@pytest.fixture(scope="module")
def tiny(tmp_path_factory):
    return TileSet(write_set(tmp_path_factory.mktemp("tiny") / "set", max_zoom=2))


def test_a_set_of_another_encoder_is_valid(tiny):
    assert tiny.available() == tiny.on_disk()
    promises.none(promises.valid(tiny))


def test_heights_without_a_common_lattice_make_gaps(tiny):
    """Each tile of that encoder rounds heights to its own range: up to decimetres on a globe."""
    faults, seams = seam_faults(tiny, 2)
    assert seams == 8 * 4 + 8 * 3
    assert any("heights differ" in fault for fault in faults)
    assert "heights differ" not in str(seam_faults(tiny, 2, tolerance=5.0)[0])


def test_a_vertex_missing_on_one_side_is_found(tiny):
    tile = tiny.tile(1, 0, 0)
    kept = tile.u.copy()
    tile.u = np.where((tile.u == QUANTIZED_MAX) & (tile.v > 0) & (tile.v < 9000), 32000, tile.u)
    try:
        assert any("1/0/0 and 1/1/0: the vertices differ" in f for f in seam_faults(tiny, 1, 5.0)[0])
    finally:
        tile.u = kept


MAX_ERROR = 0.05


class OneTile:
    """Just enough of a TileSet for promises.bounded()."""

    def __init__(self, scheme, name, tile):
        self.scheme, self.name, self._tile = scheme, name, tile

    def available(self):
        return {self.name}

    def levels(self):
        return {self.name[0]: [self.name]}

    def tile(self, *name):
        return self._tile


def all_nodes(nodes, scheme, name, shift=0):
    """A tile that keeps every node, `shift` columns displaced."""
    n = nodes.cells
    height = np.roll(nodes.tile(*name)[0], shift, axis=1)
    u, v = np.meshgrid(np.round(node_u(n)), np.round(scheme.node_v(name[0], name[2], n)))
    step = scheme.lattice_step(name[0], MAX_ERROR)
    low, high = np.floor(height.min() / step) * step, height.max() + 0.01
    q = np.round((height - low) / (high - low) * QUANTIZED_MAX)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    south_east, north_west = (a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)
    triangles = np.concatenate([np.stack(south_east, 1), np.stack(north_west, 1)])
    flat = [part.astype(np.int64).ravel() for part in (u, v, q)]
    return Tile(None, float(low), float(high), None, 0.0, None, *flat, triangles, {})


@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
def test_the_error_of_all_nodes_is_their_rounding_and_a_shift_is_found(tmp_path, profile):
    make_dem("plane", tmp_path / "a.tif", box=(10, 46, 10.5, 46.5), size=(300, 300))
    scheme = Scheme(profile)
    nodes = Nodes(Source(tmp_path / "a.tif"), scheme, 64, 11)
    name = (11, int(190.2 / 360 * scheme.tiles_x(11)), int(scheme.fraction_y(46.2) * 2048))
    good = OneTile(scheme, name, all_nodes(nodes, scheme, name))
    promises.none(promises.bounded(good, nodes, lambda z: MAX_ERROR)[0])
    shifted = OneTile(scheme, name, all_nodes(nodes, scheme, name, shift=1))
    assert "nodes exceed it" in str(promises.bounded(shifted, nodes, lambda z: MAX_ERROR)[0])
