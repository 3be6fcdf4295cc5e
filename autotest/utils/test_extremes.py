# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Every method at the ends of --max-error and on rasters that are mostly void: a set of valid tiles
without seams (P1, P6)."""

import numpy as np
import pytest

import dems
import harness
import promises
from oracle.tileset import TileSet
from test_methods import METHODS

CELLS = 16  # of a tile; the DEM fills two of zoom 9


def _speckled(heights, share):
    return np.where(np.random.default_rng(3).random(heights.shape) < share, np.nan, heights)


def _infinite(heights):
    return np.where(np.isnan(_speckled(heights, 0.2)), np.inf, _speckled(heights, 0.1))


def _one_pixel(heights):
    alone = np.full(heights.shape, np.nan)
    alone[8, 20] = heights[8, 20]
    return alone


def _spikes(heights):
    flat = np.zeros(heights.shape)
    flat[8, 8], flat[3, 20] = 8000, -8000
    return flat


KINDS = {
    "hills": lambda heights: heights,
    "speckled": lambda heights: _speckled(heights, 0.5),
    "few": lambda heights: _speckled(heights, 0.97),
    "infinite": _infinite,
    "one pixel": _one_pixel,
    "spikes": _spikes,
    "flat": np.zeros_like,
}


@pytest.fixture(scope="module")
def raster(tmp_path_factory):
    """A function kind -> path of a GeoTIFF as large as two tiles."""
    folder, cell = tmp_path_factory.mktemp("extremes"), 180.0 / 2**9 / CELLS

    def write(kind):
        heights = KINDS[kind](dems.hills(CELLS, 2 * CELLS).astype(float)).astype(np.float32)
        return dems.write(folder / f"{kind}.tif", heights, (11.25, cell, 0, 45.0, 0, -cell))

    return write


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("method", METHODS)
def test_any_max_error_and_any_voids_make_a_valid_set(raster, tmp_path, method, kind):
    path = raster(kind)
    for max_error in ("0", "1e-12", "1e300"):
        common = ("-q", "--method", method, "--tilesize", CELLS, "--max-error", max_error)
        folder = tmp_path / max_error
        harness.gdal2qmesh(*common, path, folder).succeeded()
        tiles = TileSet(folder)
        assert max(tiles.levels()) == 9
        promises.none(promises.valid(tiles))
        promises.none(promises.seamless(tiles)[0])
