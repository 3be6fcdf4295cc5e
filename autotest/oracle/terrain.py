# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""A strict decoder of quantized-mesh-1.0 tiles, written from the specification."""

import json
import struct
import zlib
from dataclasses import dataclass, field

import numpy as np

from . import earth
from .scheme import QUANTIZED_MAX

EDGE_NAMES = ("west", "south", "east", "north")
OCT_NORMALS, WATER_MASK, METADATA = 1, 2, 4


class BadTile(Exception):
    """The bytes are not a tile that the specification allows."""


@dataclass
class Tile:
    """A decoded tile. u, v, q: (n,) int64, 0..32767; triangles: (m, 3) int64; edges by name."""

    centre: np.ndarray
    min_height: float
    max_height: float
    sphere_centre: np.ndarray
    sphere_radius: float
    horizon: np.ndarray
    u: np.ndarray
    v: np.ndarray
    q: np.ndarray
    triangles: np.ndarray
    edges: dict
    extensions: dict = field(default_factory=dict)

    def heights(self):
        """Metres, as a client decodes them."""
        return self.min_height + self.q / QUANTIZED_MAX * (self.max_height - self.min_height)

    def positions(self, box):
        """(lon, lat) in degrees of the vertices of a tile with this (west, south, east, north)."""
        west, south, east, north = box
        return (
            west + self.u / QUANTIZED_MAX * (east - west),
            south + self.v / QUANTIZED_MAX * (north - south),
        )

    def ecef(self, box):
        lon, lat = self.positions(box)
        return earth.ecef(lon, lat, self.heights())

    def oct_normals(self):
        """(n, 2) uint8, or None where the tile has none."""
        payload = self.extensions.get(OCT_NORMALS)
        return None if payload is None else np.frombuffer(payload, np.uint8).reshape(-1, 2)

    def metadata(self):
        """The JSON of the metadata extension, or None."""
        payload = self.extensions.get(METADATA)
        if payload is None:
            return None
        (length,) = struct.unpack_from("<I", payload)
        if length != len(payload) - 4:
            raise BadTile("the metadata's own length differs from the extension's")
        return json.loads(payload[4:].decode("utf-8"))


class _Reader:
    def __init__(self, data):
        self.data = data
        self.at = 0

    def take(self, count, what):
        if self.at + count > len(self.data):
            raise BadTile(f"the file ends inside {what}")
        part = self.data[self.at : self.at + count]
        self.at += count
        return part

    def unpack(self, layout, what):
        return struct.unpack(layout, self.take(struct.calcsize(layout), what))

    def array(self, dtype, count, what):
        size = np.dtype(dtype).itemsize
        return np.frombuffer(self.take(size * count, what), dtype).astype(np.int64)


def _zigzag(codes):
    """Values from zigzag-coded differences."""
    values = np.cumsum((codes >> 1) ^ -(codes & 1))
    if len(values) and (values.min() < 0 or values.max() > QUANTIZED_MAX):
        raise BadTile("a vertex lies outside 0..32767")
    return values


def _high_water_mark(codes, vertices):
    fresh = codes == 0
    highest = np.cumsum(fresh) - fresh
    indices = highest - codes
    if len(indices) and (indices.min() < 0 or indices.max() >= vertices):
        raise BadTile("an index is out of range")
    return indices


def _read_extensions(reader, vertices):
    extensions = {}
    while reader.at < len(reader.data):
        kind, length = reader.unpack("<BI", "an extension's header")
        payload = reader.take(length, f"extension {kind}")
        if kind in extensions:
            raise BadTile(f"extension {kind} comes twice")
        if kind == OCT_NORMALS and length != 2 * vertices:
            raise BadTile(f"{length} bytes of normals for {vertices} vertices")
        if kind == WATER_MASK and length not in (1, 65536):
            raise BadTile(f"a water mask of {length} bytes")
        extensions[kind] = payload
    return extensions


def decode(data):
    """A Tile from the bytes of a .terrain file that is not compressed; BadTile on any fault."""
    reader = _Reader(data)
    numbers = reader.unpack("<3d2f3dd3d", "the header")
    (vertices,) = reader.unpack("<I", "the vertex count")
    if vertices < 3:
        raise BadTile(f"{vertices} vertices")
    u, v, q = (_zigzag(reader.array("<u2", vertices, "the vertices")) for _ in range(3))
    wide = vertices > 65536
    if wide and reader.at % 4 and reader.take(4 - reader.at % 4, "the padding").strip(b"\0"):
        raise BadTile("the padding is not zero")
    index_type = "<u4" if wide else "<u2"
    (count,) = reader.unpack("<I", "the triangle count")
    indices = _high_water_mark(reader.array(index_type, 3 * count, "the triangles"), vertices)
    edges = {}
    for name in EDGE_NAMES:
        (length,) = reader.unpack("<I", f"the {name} edge's length")
        edges[name] = reader.array(index_type, length, f"the {name} edge")
        if length and edges[name].max() >= vertices:
            raise BadTile(f"an index of the {name} edge is out of range")
    return Tile(
        centre=np.array(numbers[0:3]),
        min_height=numbers[3],
        max_height=numbers[4],
        sphere_centre=np.array(numbers[5:8]),
        sphere_radius=numbers[8],
        horizon=np.array(numbers[9:12]),
        u=u,
        v=v,
        q=q,
        triangles=indices.reshape(-1, 3),
        edges=edges,
        extensions=_read_extensions(reader, vertices),
    )


def gunzip(data):
    """The one gzip member that `data` must be, nothing after it."""
    inflater = zlib.decompressobj(31)
    try:
        plain = inflater.decompress(data) + inflater.flush()
    except zlib.error as error:
        raise BadTile(f"not gzip: {error}") from error
    if not inflater.eof or inflater.unused_data:
        raise BadTile("the gzip member is cut short or something follows it")
    return plain
