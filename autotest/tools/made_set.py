# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Small quantized-mesh sets whose every part can be damaged: tiles as plain parts, and an encoder of our own in
Python that writes whatever it is given. The undamaged set has no fault: grids on a surface that is linear in
latitude, heights in steps that all tiles share.
Format: github.com/CesiumGS/quantized-mesh (quantized-mesh-1.0 and its extensions)."""

import gzip
import json
import pathlib
import struct
from dataclasses import dataclass, field

import numpy as np
from tiny_set import by_first_use, ecef, grid_triangles, high_water_mark, horizon_point, oct_encode, zigzag_deltas

MAX = 32767
RADII = np.array([6378137.0, 6378137.0, 6356752.3142451793])
STEP = 0.01  # metres between two quantized heights of a good tile
NORMALS, WATER, METADATA = 1, 2, 4
SIDES = ("west", "south", "east", "north")


def linear(lon, lat):
    """Heights of the good set, metres: any triangulation shows them exactly."""
    return 100.0 + lat + 0.0 * lon


def box_of(z, x, y):
    size = 180 / 2**z
    return x * size - 180, y * size - 90, (x + 1) * size - 180, (y + 1) * size - 90


@dataclass
class Tile:
    """The parts of one .terrain file."""

    box: tuple
    u: np.ndarray
    v: np.ndarray
    q: np.ndarray
    triangles: list
    low: float
    high: float
    edges: list = field(default_factory=list)
    extensions: list = field(default_factory=list)  # (id, bytes)
    centre: np.ndarray = None
    sphere: np.ndarray = None
    radius: float = 0.0
    horizon: np.ndarray = None

    def heights(self):
        return self.low + (self.high - self.low) * self.q / MAX

    def points(self):
        west, south, east, north = self.box
        return ecef(west + (east - west) * self.u / MAX, south + (north - south) * self.v / MAX, self.heights())

    def fit(self):
        """Header and edge lists from the vertices."""
        points = self.points()
        self.sphere = (points.min(0) + points.max(0)) / 2
        self.radius = float(np.linalg.norm(points - self.sphere, axis=1).max()) + 0.001
        self.centre = self.sphere.copy()
        direction = self.sphere / RADII
        direction = direction / np.linalg.norm(direction)
        self.horizon = horizon_point(points, direction)
        if self.box[2] - self.box[0] > 90:  # nothing hides half a globe
            self.horizon = direction * 1e200
        self.edges = [np.flatnonzero(on) for on in (self.u == 0, self.v == 0, self.u == MAX, self.v == MAX)]
        return self

    def encode(self, index_bytes=2, lengths="<", codes=None):
        out = struct.pack("<3d2f3dd3d", *self.centre, self.low, self.high, *self.sphere, self.radius, *self.horizon)
        out += struct.pack("<I", len(self.u))
        for values in (self.u, self.v, self.q):
            out += zigzag_deltas(np.asarray(values, int))
        kind = {2: "<u2", 4: "<u4"}[index_bytes]
        out += b"\0" * (-len(out) % index_bytes)
        if codes is None:
            codes = high_water_mark(self.triangles)
        out += struct.pack("<I", len(codes) // 3) + np.array(codes).astype(kind).tobytes()
        for edge in self.edges:
            out += struct.pack("<I", len(edge)) + np.asarray(edge).astype(kind).tobytes()
        for number, data in self.extensions:
            out += struct.pack("<B", number) + struct.pack(lengths + "I", len(data)) + data
        return out

    def replace_extension(self, number, data):
        self.extensions = [(n, data if n == number else old) for n, old in self.extensions]


def make_tile(box, cells, height_of=linear, normals=True):
    order, indices = by_first_use(grid_triangles(cells))
    row, column = np.divmod(np.array(order), cells + 1)
    u = np.round(MAX * column / cells).astype(int)
    v = np.round(MAX * row / cells).astype(int)
    lon, lat = box[0] + (box[2] - box[0]) * u / MAX, box[1] + (box[3] - box[1]) * v / MAX
    high = float(np.float32(MAX * STEP))
    q = np.round(height_of(lon, lat) / STEP).astype(int)
    tile = Tile(box, u, v, q, indices, 0.0, high).fit()
    if normals:
        up = ecef(np.where(lon == 180, -180, lon), lat, 0 * lon) / RADII**2
        tile.extensions.append((NORMALS, oct_encode(up / np.linalg.norm(up, axis=1)[:, None]).tobytes()))
    return tile


class MadeSet:
    """Levels 0 to 2 of the square degrees 0..90 east and north: both roots, then 1 and 4 tiles."""

    def __init__(self, height_of=linear):
        self.tiles = {(0, x, 0): make_tile(box_of(0, x, 0), 32, height_of) for x in (0, 1)}
        for name in [(1, 2, 1)] + [(2, x, y) for x in (4, 5) for y in (2, 3)]:
            self.tiles[name] = make_tile(box_of(*name), 16 if name[0] == 1 else 8, height_of)
        self.raw = {}  # name -> bytes written as they are
        self.layer = {
            "tilejson": "2.1.0",
            "name": "made",
            "version": "1.0.0",
            "format": "quantized-mesh-1.0",
            "attribution": "a formula",
            "scheme": "tms",
            "projection": "EPSG:4326",
            "tiles": ["{z}/{x}/{y}.terrain?v={version}"],
            "bounds": [0, 0, 90, 90],
            "minzoom": 0,
            "maxzoom": 2,
            "extensions": ["octvertexnormals"],
            "available": [[self.range(0, 0, 1, 0)], [self.range(2, 1, 2, 1)], [self.range(4, 2, 5, 3)]],
        }
        self.layer_text = None
        self.packed = set()  # tiles to compress
        self.path = "{z}/{x}/{y}.terrain"

    @staticmethod
    def range(x0, y0, x1, y1):
        return {"startX": x0, "startY": y0, "endX": x1, "endY": y1}

    def add_metadata(self):
        """The metadata extension in both roots, as layer.json then promises."""
        self.layer["metadataAvailability"] = 10
        self.layer["extensions"].append("metadata")
        for x in (0, 1):
            levels = self.layer["available"][1:] if x else [[], []]
            text = json.dumps({"available": levels}).encode()
            self.tiles[0, x, 0].extensions.append((METADATA, struct.pack("<I", len(text)) + text))

    def write(self, folder):
        folder = pathlib.Path(folder)
        for z, x, y in set(self.tiles) | set(self.raw):
            data = self.raw.get((z, x, y))
            if data is None:
                data = self.tiles[z, x, y].encode()
            if (z, x, y) in self.packed:
                data = gzip.compress(data, mtime=0)
            file = folder / self.path.format(z=z, x=x, y=y)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)
        text = json.dumps(self.layer) if self.layer_text is None else self.layer_text
        folder.mkdir(exist_ok=True)
        if text:
            (folder / "layer.json").write_text(text, encoding="utf-8")
        return folder
