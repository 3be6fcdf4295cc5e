# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Sets of a formula by an encoder that shares no code with the product (tools/tiny_set.py): what other
programs may write, and planes of which every height is known."""

import gzip
import json
import pathlib

from oracle.scheme import Scheme
from tiny_set import encode_tile


def plane(lon, lat):
    """Metres; within 0..5000 on the whole globe."""
    return 1800 + 6 * lon - 11 * lat


class Writer:
    """A folder with a set. `row_from_north`: rows of the file names count from the north."""

    def __init__(self, folder, profile="geodetic", cells=4, height=plane, compress=True, from_north=False):
        self.folder = pathlib.Path(folder)
        self.scheme = Scheme(profile)
        self.cells, self.height = cells, height
        self.compress, self.from_north = compress, from_north
        self.available = []

    def path(self, z, x, y):
        row = self.scheme.tiles_y(z) - 1 - y if self.from_north else y
        return self.folder / str(z) / str(x) / f"{row}.terrain"

    def tile(self, z, x, y):
        return encode_tile(self.scheme.box(z, x, y), self.cells, self.height)

    def write_tile(self, z, x, y, data=None):
        data = self.tile(z, x, y) if data is None else data
        path = self.path(z, x, y)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(gzip.compress(data, mtime=0) if self.compress else data)
        return path

    def write_level(self, z, x0, y0, x1, y1):
        """All tiles of a rectangle, and its entry under `available`."""
        for x in range(x0, x1 + 1):
            for y in range(y0, y1 + 1):
                self.write_tile(z, x, y)
        self.available += [[] for _ in range(z + 1 - len(self.available))]
        self.available[z].append({"startX": x0, "startY": y0, "endX": x1, "endY": y1})
        return self

    def write_layer(self, **more):
        """layer.json; keys with the value None are left out."""
        layer = {
            "format": "quantized-mesh-1.0",
            "tiles": ["{z}/{x}/{y}.terrain?v={version}"],
            "version": "1.0.0",
            "projection": "EPSG:4326" if self.scheme.profile == "geodetic" else "EPSG:3857",
            "scheme": "slippyMap" if self.from_north else "tms",
            "available": self.available,
            **more,
        }
        layer = {key: value for key, value in layer.items() if value is not None}
        (self.folder / "layer.json").write_text(json.dumps(layer), encoding="utf-8")
        return self.folder


def pyramid(folder, profile="geodetic", top=3, **options):
    """The whole globe down to a level."""
    writer = Writer(folder, profile, **options)
    for z in range(top + 1):
        writer.write_level(z, 0, 0, writer.scheme.tiles_x(z) - 1, writer.scheme.tiles_y(z) - 1)
    return writer
