# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Checks of a whole set against the promises; each returns faults, empty when all is well."""

import functools

import numpy as np

from oracle import tin, validity
from oracle.nodes import Nodes, Source
from oracle.scheme import QUANTIZED_MAX, coarse_step, node_u
from oracle.tileset import seam_faults

FLOAT_SLACK = 1e-3  # metres: heights are float32 on the way


def none(faults):
    """Asserts that there are no faults; names the first ones."""
    text = [f"{len(faults)} faults, the first:", *map(str, faults[:12])]
    assert not faults, "\n".join(text)


def valid(tiles):
    """P6: every tile of the set."""
    faults = []
    for name in sorted(tiles.available()):
        tile, box = tiles.tile(*name), tiles.scheme.box(*name)
        found = validity.mesh_faults(tile)
        found += validity.header_faults(tile, box) + validity.horizon_faults(tile, box, viewers=12)
        faults += [f"{'/'.join(map(str, name))}: {fault}" for fault in found]
    return faults


def seamless(tiles, nodes=None):
    """P1: (faults, seams compared), all levels. With the oracle's `nodes`, tiles whose heights are too
    far apart for the level's lattice may be off their neighbours by half of their step."""
    limits = level_errors(tiles)

    @functools.lru_cache(maxsize=None)
    def gap(name):
        return 0.0 if nodes is None else step_of_coarse_tile(nodes, name, limits[name[0]]) / 2

    faults, seams = [], 0
    for z in tiles.levels():
        found, count = seam_faults(tiles, z, gap=gap)
        faults += found
        seams += count
    return faults, seams


def level_errors(tiles, max_error=None):
    """Zoom -> max error the set was asked for: a function of the zoom, or the default."""
    top = max(tiles.levels())
    if max_error is None:
        return {z: tiles.scheme.default_max_error(z, top) for z in tiles.levels()}
    return {z: max_error(z) for z in tiles.levels()}


@functools.lru_cache(maxsize=2)
def nodes_of(path, profile, cells, max_zoom, void_fill=0.0, **options):
    """The oracle's nodes of a DEM (kept: the same set is looked at more than once)."""
    from oracle.scheme import Scheme

    return Nodes(Source(path), Scheme(profile), cells, max_zoom, void_fill, **options)


def step_of_coarse_tile(nodes, name, max_error):
    """Metres; 0 unless the heights of the tile's nodes exceed what the lattice of the level, whose max
    error is given, holds."""
    height, tolerance, _, _ = nodes.tile(*name)
    step = nodes.scheme.lattice_step(name[0], max_error)
    return coarse_step(step, (height - tolerance).min(), (height + tolerance).max())


def allowed_errors(nodes, name, max_error, limit=None):
    """What each node of a tile may be off: the max error, or `limit` where that is given.

    A border's vertices keep it within the max error where heights are multiples of S. A coarse tile
    rounds them again, to multiples of its own step: that moves the border by half of that step at
    most, for the multiple of S nearest to a height is no further than that from the coarse multiple
    nearest to it. The inside makes up for it."""
    limit = max_error if limit is None else limit
    coarse = step_of_coarse_tile(nodes, name, max_error)
    allowed = np.full((nodes.cells + 1, nodes.cells + 1), max(limit, coarse / 2))
    for edge in (allowed[0], allowed[-1], allowed[:, 0], allowed[:, -1]):
        edge[:] = limit + coarse / 2
    return allowed + FLOAT_SLACK


def rounding_bound(height, node_u, node_v, step):
    """How far off a mesh of *all* nodes may be at each node because vertices lie on whole (u, v) and
    heights on multiples of `step`: the steepest slopes around the node times its displacement."""
    bound = np.full(height.shape, step / 2)
    for grid, out, at in ((height, bound, node_u), (height.T, bound.T, node_v)):
        slope = np.pad(np.abs(np.diff(grid, axis=1)) / np.diff(np.round(at)), ((1, 1), (1, 1)))
        beside = np.maximum(slope[:, 1:], slope[:, :-1])
        around = np.maximum(beside[1:-1], np.maximum(beside[2:], beside[:-2]))
        out += around * np.abs(np.round(at) - at)
    return bound


def bounded(tiles, nodes, max_error=None, rounding=False, promised=True):
    """P2: (faults, level -> largest error seen). `nodes`: the oracle's. `rounding`: a method that is
    not driven by error may be as far off as rounding its vertices makes it; not `promised`: as far
    as it likes, and what is left are cover and header."""
    limits = level_errors(tiles, max_error)
    u, faults, reached = node_u(nodes.cells), [], {}
    for z, x, y in sorted(tiles.available()):
        tile, v = tiles.tile(z, x, y), tiles.scheme.node_v(z, y, nodes.cells)
        surface = tin.evaluate(tile, u, v)
        where = f"{z}/{x}/{y}"
        if np.isnan(surface).any():
            faults.append(f"{where}: {int(np.isnan(surface).sum())} nodes are not covered")
            continue
        height, tolerance, doubtful, _ = nodes.tile(z, x, y)
        error = np.where(doubtful, 0.0, np.abs(surface - height) - tolerance)
        reached[z] = max(reached.get(z, 0.0), float(error.max()))
        limit = limits[z]
        if rounding:
            step = nodes.scheme.lattice_step(z, limit)
            limit = max(limit, float(rounding_bound(height, u, v, step).max()))
        if not promised:
            limit = np.inf
        excess = error - allowed_errors(nodes, (z, x, y), limits[z], limit)
        if excess.max() > 0:
            j, i = np.unravel_index(int(excess.argmax()), error.shape)
            faults.append(
                f"{where}: node ({i}, {j}) is {error[j, i]:.4f} m off ({surface[j, i]:.3f}, not "
                f"{height[j, i]:.3f}); {error[j, i] - excess[j, i]:.4f} m are allowed, "
                f"{int((excess > 0).sum())} nodes exceed it"
            )
        faults += [f"{where}: {f}" for f in _header_range_faults(tile, nodes, limits, (z, x, y))]
    return faults, reached


def _header_range_faults(tile, nodes, limits, name):
    """The header's heights cover the nodes (to the tolerance) and are no wider than the height
    lattice asks: a multiple of S below, 32767 S / n above with the largest whole n."""
    height, tolerance, doubtful, _ = nodes.tile(*name)
    if doubtful.any():
        return []
    step = nodes.scheme.lattice_step(name[0], limits[name[0]])
    slack = float(tolerance.max()) + FLOAT_SLACK
    low, high = float(height.min()), float(height.max())
    if high - low > QUANTIZED_MAX * step - 2 * step:
        return []
    faults = []
    if not low - step - slack <= tile.min_height <= low + slack:
        faults.append(f"min height {tile.min_height} where the nodes' lowest is {low:.3f}, S {step}")
    if abs(tile.min_height / step - round(tile.min_height / step)) > 1e-6:
        faults.append(f"min height {tile.min_height} is not a multiple of S = {step}")
    if tile.max_height < high - slack:
        faults.append(f"max height {tile.max_height} is below the nodes' highest {high:.3f}")
    needed = high + step + slack - tile.min_height
    if tile.max_height - tile.min_height > max(2 * needed, 8.01):
        faults.append(f"max height {tile.max_height} is far above the nodes' highest {high:.3f}")
    return faults
