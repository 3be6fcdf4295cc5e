# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""P1, P2 and P6 on whole pyramids: every DEM, all zooms 0..native, both profiles."""

import json

import pytest

import dems
import harness
import promises
from oracle.nodes import Nodes, Source
from oracle.tileset import TileSet

MATRIX = [(name, profile) for profile in ("geodetic", "mercator") for name in dems.DEMS]
matrix = pytest.mark.parametrize("name, profile", MATRIX)
AFFINE = {"jacksboro", "global", "void", "bathymetry", "antimeridian"}


def options(profile):
    return ("-q", "-p", profile)


@matrix
def test_every_tile_is_valid(tile_set, name, profile):
    """P6"""
    promises.none(promises.valid(tile_set(name, *options(profile))))


@matrix
def test_no_seam_shows(tile_set, name, profile):
    """P1"""
    faults, seams = promises.seamless(tile_set(name, *options(profile)))
    promises.none(faults)
    assert seams > 0


@matrix
def test_error_is_bounded_at_every_node(tile_set, dem, name, profile):
    """P2, against nodes sampled by the oracle"""
    tiles = tile_set(name, *options(profile))
    top = max(tiles.levels())
    nodes = promises.nodes_of(dem(name), profile, 256, top)
    faults, reached = promises.bounded(tiles, nodes)
    promises.none(faults)
    if name in AFFINE:
        for level in tiles.layer["qmesh"]["levels"]:
            assert level["errorReached"] == pytest.approx(reached[level["zoom"]], abs=2e-3)
            limit = promises.level_errors(tiles)[level["zoom"]]
            assert level["maxError"] == pytest.approx(limit, rel=1e-9)


@pytest.mark.parametrize("profile", ["geodetic", "mercator"])
@pytest.mark.parametrize("cells", [8, 16, 64, 1024])
def test_the_promises_hold_for_other_tile_sizes(tile_set, dem, cells, profile):
    tiles = tile_set("small", *options(profile), "--tilesize", cells)
    promises.none(promises.valid(tiles))
    promises.none(promises.seamless(tiles)[0])
    nodes = promises.nodes_of(dem("small"), profile, cells, max(tiles.levels()))
    promises.none(promises.bounded(tiles, nodes)[0])


FINE = 64  # --tilesize at which the heights 0 (void) and 284 m of slovenia exceed 32767 S of zoom 19


@pytest.fixture(scope="module")
def coarse_tiles(dem, tmp_path_factory):
    """(tiles, the oracle's nodes, what the run reported): tiles along the outline of the data are coarse."""
    folder = tmp_path_factory.mktemp("coarse")
    given = (*options("geodetic"), "--tilesize", FINE, "--report", folder / "report.json")
    harness.gdal2qmesh(*given, dem("slovenia"), folder / "set").succeeded()
    tiles = TileSet(folder / "set")
    nodes = promises.nodes_of(dem("slovenia"), "geodetic", FINE, max(tiles.levels()))
    return tiles, nodes, json.loads((folder / "report.json").read_text())["zooms"]


def test_tiles_with_a_cliff_keep_the_promises_but_for_the_rounding_of_their_borders(coarse_tiles):
    """P1 and P2 where heights are too far apart for the level's lattice (docs/architecture.md, "Why there
    is no seam"): such tiles are those the nodes say, and all are counted."""
    tiles, nodes, levels = coarse_tiles
    promises.none(promises.bounded(tiles, nodes)[0])
    promises.none(promises.seamless(tiles, nodes)[0])
    limits, names = promises.level_errors(tiles), tiles.levels()
    for level in levels:
        z = level["zoom"]
        steps = [promises.step_of_coarse_tile(nodes, name, limits[z]) for name in names[z]]
        assert level["coarseTiles"] == sum(step > 0 for step in steps)
        assert level["largestCoarseStep"] == max(steps)
    assert sum(level["coarseTiles"] for level in levels) > 50


def test_the_bound_finds_nodes_a_hundredth_of_a_cell_away(coarse_tiles, dem):
    """Of the check above: many meshes exceed the bound against nodes sampled that far to the side."""
    tiles, nodes, _ = coarse_tiles
    source, top = Source(dem("slovenia")), max(tiles.levels())
    lon, lat = source.outline()
    middle, spacing = (lon.mean(), lat.mean()), 360.0 / nodes.columns(top)
    cell = source.pixel_of(middle[0] + spacing, middle[1]) - source.pixel_of(*middle)
    exact = source.sample
    source.sample = lambda px, py: exact(px + cell[0] / 100, py + cell[1] / 100)
    aside = Nodes(source, tiles.scheme, FINE, top)
    assert len(promises.bounded(tiles, aside)[0]) > 50


@pytest.mark.parametrize("name", ["antimeridian", "antimeridian_utm", "global"])
def test_the_antimeridian_is_a_seam_like_any_other(tile_set, name):
    """The tiles left and right of 180 degrees are there, so test_no_seam_shows compared them."""
    tiles = tile_set(name, *options("geodetic"))
    for z, level in tiles.levels().items():
        last = tiles.scheme.tiles_x(z) - 1
        rows = {y for _, x, y in level if x == 0} & {y for _, x, y in level if x == last}
        assert rows, f"zoom {z}: no row has tiles on both sides"
    assert len(tiles.on_disk()) < 500


@pytest.mark.parametrize("name", ["global", "north_pole", "south_pole"])
def test_a_pole_has_one_height_for_all_levels(tile_set, dem, name):
    tiles = tile_set(name, *options("geodetic"))
    top = max(tiles.levels())
    nodes = promises.nodes_of(dem(name), "geodetic", 256, top)
    north = name != "south_pole"
    for z, level in tiles.levels().items():
        row = tiles.scheme.tiles_y(z) - 1 if north else 0
        at_pole = [t for t in level if t[2] == row]
        assert at_pole, f"zoom {z} has no tile at the pole"
        step = tiles.scheme.lattice_step(z, promises.level_errors(tiles)[z])
        for t in at_pole:
            tile = tiles.tile(*t)
            heights = tile.heights()[tile.v == (32767 if north else 0)]
            assert heights == pytest.approx(nodes.poles[north], abs=step / 2 + 0.05)
