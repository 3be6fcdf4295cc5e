# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""A tile folder on disk as a client sees it: layer.json, the files, and the seams between tiles."""

import json
import pathlib
import re

import numpy as np

from . import terrain
from .scheme import QUANTIZED_MAX, Scheme

_TILE_PATH = re.compile(r"(\d+)/(\d+)/(\d+)\.terrain$")


class TileSet:
    """REQUIRES: the folder holds a layer.json. Tiles are named (z, x, y), rows from the south."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.layer = json.loads((self.folder / "layer.json").read_text(encoding="utf-8"))
        mercator = self.layer.get("projection", "EPSG:4326") == "EPSG:3857"
        self.scheme = Scheme("mercator" if mercator else "geodetic")
        self.from_north = self.layer.get("scheme", "tms") == "slippyMap"
        self._tiles = {}

    def path(self, z, x, y):
        row = self.scheme.tiles_y(z) - 1 - y if self.from_north else y
        return self.folder / str(z) / str(x) / f"{row}.terrain"

    def tile(self, z, x, y):
        """The decoded tile, kept for the next call."""
        if (z, x, y) not in self._tiles:
            data = self.path(z, x, y).read_bytes()
            if data[:2] == b"\x1f\x8b":
                data = terrain.gunzip(data)
            self._tiles[z, x, y] = terrain.decode(data)
        return self._tiles[z, x, y]

    def on_disk(self):
        """Names of all tile files, whatever layer.json says."""
        names = set()
        for file in self.folder.rglob("*.terrain"):
            match = _TILE_PATH.fullmatch(file.relative_to(self.folder).as_posix())
            if match is None:
                raise ValueError(f"{file} has not the form z/x/y.terrain")
            z, x, y = map(int, match.groups())
            names.add((z, x, self.scheme.tiles_y(z) - 1 - y if self.from_north else y))
        return names

    def available(self):
        """Names of all tiles that layer.json lists; ValueError where one is listed twice."""
        names = []
        for z, ranges in enumerate(self.layer["available"]):
            for r in ranges:
                columns = range(r["startX"], r["endX"] + 1)
                names += [(z, x, y) for x in columns for y in range(r["startY"], r["endY"] + 1)]
        if len(set(names)) != len(names):
            raise ValueError("layer.json lists a tile twice")
        return set(names)

    def levels(self):
        """Zoom -> sorted tile names."""
        levels = {}
        for name in sorted(self.available()):
            levels.setdefault(name[0], []).append(name)
        return levels


def edge(tile, name):
    """An edge's vertices from south or west on: (position, metres, normals or None)."""
    mask, along = {
        "west": (tile.u == 0, tile.v),
        "east": (tile.u == QUANTIZED_MAX, tile.v),
        "south": (tile.v == 0, tile.u),
        "north": (tile.v == QUANTIZED_MAX, tile.u),
    }[name]
    chosen = np.flatnonzero(mask)
    chosen = chosen[np.argsort(along[chosen])]
    normals = tile.oct_normals()
    return along[chosen], tile.heights()[chosen], None if normals is None else normals[chosen]


def _seam_faults(first, second, where, tolerance):
    (at_a, height_a, normal_a), (at_b, height_b, normal_b) = first, second
    if not np.array_equal(at_a, at_b):
        return [f"{where}: the vertices differ"]
    faults = []
    gap = float(np.abs(height_a - height_b).max())
    if gap > tolerance:
        faults.append(f"{where}: the heights differ by {gap:.6f} m")
    if (normal_a is None) != (normal_b is None):
        faults.append(f"{where}: one side has no normals")
    elif normal_a is not None and not np.array_equal(normal_a, normal_b):
        faults.append(f"{where}: the normals differ")
    return faults


def seam_faults(tiles, z, tolerance=1e-3, gap=lambda name: 0.0):
    """Promise P1 for the level z of a TileSet: (faults, number of seams compared). `gap`: metres by
    which the heights of a tile may be off its neighbour's beyond the tolerance."""
    level = set(tiles.levels().get(z, []))
    columns = tiles.scheme.tiles_x(z)
    faults, seams = [], 0
    for _, x, y in sorted(level):
        here = tiles.tile(z, x, y)
        east = (z, (x + 1) % columns, y)
        north = (z, x, y + 1)
        for other, mine, theirs in ((east, "east", "west"), (north, "north", "south")):
            if other in level:
                seams += 1
                there = edge(tiles.tile(*other), theirs)
                where = f"{z}/{x}/{y} and {'/'.join(map(str, other))}"
                allowed = tolerance + max(gap((z, x, y)), gap(other))
                faults += _seam_faults(edge(here, mine), there, where, allowed)
    if tiles.scheme.profile == "geodetic":
        faults += _pole_faults(tiles, z, sorted(level), tolerance)
    return faults, seams


def _pole_faults(tiles, z, level, tolerance):
    """Every vertex of a pole's row has one height and one normal, the whole row long."""
    faults = []
    for row, name, upwards in ((0, "south", -1.0), (tiles.scheme.tiles_y(z) - 1, "north", 1.0)):
        edges = [edge(tiles.tile(*t), name) for t in level if t[2] == row]
        if not edges:
            continue
        heights = np.concatenate([e[1] for e in edges])
        if np.ptp(heights) > tolerance:
            faults.append(f"zoom {z}: the {name} pole's heights differ by {np.ptp(heights)} m")
        if edges[0][2] is not None:
            normals = terrain.earth.oct_decode(np.concatenate([e[2] for e in edges]))
            if (normals[:, 2] * upwards < 0.9995).any():
                faults.append(f"zoom {z}: a normal at the {name} pole is not the ellipsoid's")
    return faults
