# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The surface of a decoded tile, evaluated on a lattice of positions."""

import numpy as np

_SLACK = 1e-7


def _expand(first, last):
    """For ranges first..last-1: (which range, the number) of every member."""
    counts = np.maximum(last - first, 0)
    owner = np.repeat(np.arange(len(counts)), counts)
    offset = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    return owner, first[owner] + offset


def _row_spans(x, y, line):
    """West and east end of each triangle (rows of x and y) on its horizontal line."""
    west = np.full(len(line), np.inf)
    east = np.full(len(line), -np.inf)
    for a, b in ((0, 1), (1, 2), (2, 0)):
        xa, xb, ya, yb = x[:, a], x[:, b], y[:, a], y[:, b]
        meets = (np.minimum(ya, yb) - _SLACK <= line) & (line <= np.maximum(ya, yb) + _SLACK)
        level = ya == yb
        part = np.clip((line - ya) / np.where(level, 1.0, yb - ya), 0.0, 1.0)
        cut = xa + part * (xb - xa)
        low = np.where(level, np.minimum(xa, xb), cut)
        high = np.where(level, np.maximum(xa, xb), cut)
        west = np.where(meets, np.minimum(west, low), west)
        east = np.where(meets, np.maximum(east, high), east)
    return west, east


def evaluate(tile, node_u, node_v):
    """Heights of the tile's surface at the positions (node_u[i], node_v[j]), both ascending and in
    quantized units: an array [j, i], metres; NaN where no triangle covers the position."""
    x = tile.u[tile.triangles].astype(float)
    y = tile.v[tile.triangles].astype(float)
    h = tile.heights()[tile.triangles]
    owner, row = _expand(
        np.searchsorted(node_v, y.min(axis=1) - _SLACK),
        np.searchsorted(node_v, y.max(axis=1) + _SLACK, "right"),
    )
    west, east = _row_spans(x[owner], y[owner], node_v[row])
    pair, column = _expand(
        np.searchsorted(node_u, west - _SLACK), np.searchsorted(node_u, east + _SLACK, "right")
    )
    t, row = owner[pair], row[pair]
    px, py = node_u[column], node_v[row]
    x, y, h = x[t], y[t], h[t]

    def doubled_area(ax, ay, bx, by):
        return (bx - ax) * (py - ay) - (by - ay) * (px - ax)

    weights = np.stack(
        [
            doubled_area(x[:, 1], y[:, 1], x[:, 2], y[:, 2]),
            doubled_area(x[:, 2], y[:, 2], x[:, 0], y[:, 0]),
            doubled_area(x[:, 0], y[:, 0], x[:, 1], y[:, 1]),
        ],
        axis=1,
    )
    # A position on an edge is a rounding error outside: without the clamp the plane of a sliver
    # would be continued steeply there.
    weights = np.maximum(weights, 0.0)
    total = weights.sum(axis=1)
    usable = total > 0
    surface = np.full((len(node_v), len(node_u)), np.nan)
    surface[row[usable], column[usable]] = (weights * h).sum(axis=1)[usable] / total[usable]
    return surface
