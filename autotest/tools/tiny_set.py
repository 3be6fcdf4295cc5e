#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""A small quantized-mesh set from a formula, written by an encoder that shares no code with the product.

    tiny_set.py OUTPUT_DIR [--max-zoom 4] [--box W S E N] [--cells 16] [--plain] [--kind global]

Regular grids in the geodetic profile with TMS rows, normals by the gradient of the surface (the formulas of
make_dem.py). It is the known-good terrain for tests of the preview page and of the client scripts.
Format: github.com/CesiumGS/quantized-mesh (quantized-mesh-1.0, extension octvertexnormals).
"""
import argparse
import gzip
import json
import pathlib
import struct

import numpy as np

from make_dem import surface

A, B = 6378137.0, 6356752.3142451793
E2 = 1 - (B / A) ** 2


def ecef(lon, lat, height):
    lam, phi = np.radians(lon), np.radians(lat)
    n = A / np.sqrt(1 - E2 * np.sin(phi) ** 2)
    return np.stack([(n + height) * np.cos(phi) * np.cos(lam),
                     (n + height) * np.cos(phi) * np.sin(lam),
                     (n * (1 - E2) + height) * np.sin(phi)], -1)


def horizon_point(points, direction):
    """The point along `direction` (ellipsoid-scaled) below whose horizon all points are."""
    scaled = points / np.array([A, A, B])
    size2 = np.maximum((scaled**2).sum(-1), 1.0)
    size = np.sqrt(size2)
    cos_a = np.clip((scaled @ direction) / np.sqrt((scaled**2).sum(-1)), -1, 1)
    sin_a = np.sqrt(1 - cos_a**2)
    denominator = cos_a / size - sin_a * np.sqrt(size2 - 1) / size
    return direction * (1 / denominator.min() if denominator.min() > 1e-3 else 1e3)


def high_water_mark(indices):
    codes, highest = [], 0
    for index in indices:
        codes.append(highest - index)
        highest += index == highest
    return codes


def grid_triangles(cells):
    """Indices of a (cells+1)^2 grid, row by row from the south-west, counter-clockwise."""
    side = cells + 1
    out = []
    for row in range(cells):
        for column in range(cells):
            sw = row * side + column
            out += [sw, sw + 1, sw + side + 1, sw, sw + side + 1, sw + side]
    return out


def by_first_use(indices):
    """Vertex order in which high-water-mark coding works, and the renumbered indices."""
    order, number = [], {}
    for index in indices:
        if index not in number:
            number[index] = len(order)
            order.append(index)
    return order, [number[index] for index in indices]


def oct_encode(normal):
    x, y, z = (normal / np.abs(normal).sum(-1, keepdims=True)).T
    fold = z < 0
    fx = np.where(fold, (1 - np.abs(y)) * np.where(x < 0, -1, 1), x)
    fy = np.where(fold, (1 - np.abs(x)) * np.where(y < 0, -1, 1), y)
    return np.round((np.stack([fx, fy], -1) + 1) / 2 * 255).astype(np.uint8)


def surface_normals(lon, lat, height_of, step):
    """Normals of the surface by differences of ECEF positions `step` degrees apart."""
    south, north = np.clip(lat - step, -90, 90), np.clip(lat + step, -90, 90)
    east_west = (ecef(lon + step, lat, height_of(lon + step, lat))
                 - ecef(lon - step, lat, height_of(lon - step, lat)))
    north_south = ecef(lon, north, height_of(lon, north)) - ecef(lon, south, height_of(lon, south))
    normal = np.cross(east_west, north_south)
    length = np.linalg.norm(normal, axis=-1, keepdims=True)
    up = ecef(lon, lat, 0 * lon) / np.array([A * A, A * A, B * B])
    up /= np.linalg.norm(up, axis=-1, keepdims=True)
    return np.where((np.abs(lat) > 90 - step)[..., None] | (length == 0), up, normal / np.maximum(length, 1e-9))


def zigzag_deltas(values):
    deltas = np.diff(values, prepend=0)
    return ((deltas << 1) ^ (deltas >> 31)).astype("<u2").tobytes()


def encode_tile(box, cells, height_of):
    """One .terrain file (not compressed) of the box west, south, east, north in degrees."""
    west, south, east, north = box
    order, indices = by_first_use(grid_triangles(cells))
    row, column = np.divmod(np.array(order), cells + 1)
    u = np.round(32767 * column / cells).astype(int)
    v = np.round(32767 * row / cells).astype(int)
    lon, lat = west + (east - west) * u / 32767, south + (north - south) * v / 32767
    height = height_of(lon, lat)
    low, high = float(np.float32(height.min())), float(np.float32(height.max() + 0.01))
    q = np.clip(np.round((height - low) / (high - low) * 32767), 0, 32767).astype(int)
    points = ecef(lon, lat, low + (high - low) * q / 32767)
    centre = (points.min(0) + points.max(0)) / 2
    radius = np.linalg.norm(points - centre, axis=1).max()
    direction = centre / np.array([A, A, B])
    direction = direction / np.linalg.norm(direction)

    out = struct.pack("<3d2f3dd3d", *centre, low, high, *centre, radius, *horizon_point(points, direction))
    out += struct.pack("<I", len(order)) + zigzag_deltas(u) + zigzag_deltas(v) + zigzag_deltas(q)
    width = "<u2" if len(order) <= 65536 else "<u4"
    out += bytes(-len(out) % np.dtype(width).itemsize)
    out += struct.pack("<I", len(indices) // 3) + np.array(high_water_mark(indices), width).tobytes()
    for edge in (u == 0, v == 0, u == 32767, v == 32767):  # west, south, east, north
        members = np.flatnonzero(edge)
        out += struct.pack("<I", len(members)) + members.astype(width).tobytes()
    normals = oct_encode(surface_normals(lon, lat, height_of, (north - south) / cells / 2)).tobytes()
    return out + struct.pack("<BI", 1, len(normals)) + normals


def tile_range(box, zoom):
    """startX, startY, endX, endY of the tiles that meet the box's inside."""
    size = 180 / 2**zoom
    west, south, east, north = box
    return (int((west + 180) // size), int((south + 90) // size),
            int(-(-(east + 180) // size)) - 1, int(-(-(north + 90) // size)) - 1)


def write_set(folder, max_zoom=4, box=(-180, -90, 180, 90), cells=16, plain=False, kind="global"):
    folder = pathlib.Path(folder)
    available = []
    for zoom in range(max_zoom + 1):
        x0, y0, x1, y1 = (0, 0, 1, 0) if zoom == 0 else tile_range(box, zoom)
        available.append([{"startX": x0, "startY": y0, "endX": x1, "endY": y1}])
        size = 180 / 2**zoom
        for x in range(x0, x1 + 1):
            column = folder / str(zoom) / str(x)
            column.mkdir(parents=True, exist_ok=True)
            for y in range(y0, y1 + 1):
                tile_box = (x * size - 180, y * size - 90, (x + 1) * size - 180, (y + 1) * size - 90)
                tile = encode_tile(tile_box, cells if zoom else max(cells, 32),
                                   lambda lon, lat: surface(kind, lon, lat))
                data = tile if plain else gzip.compress(tile, mtime=0)
                (column / f"{y}.terrain").write_bytes(data)
    layer = {
        "tilejson": "2.1.0", "name": "formula", "version": "1.0.0", "format": "quantized-mesh-1.0",
        "attribution": "Heights from a formula", "scheme": "tms", "projection": "EPSG:4326",
        "tiles": ["{z}/{x}/{y}.terrain?v={version}"], "bounds": list(box), "minzoom": 0,
        "maxzoom": max_zoom, "extensions": ["octvertexnormals"], "available": available,
    }
    (folder / "layer.json").write_text(json.dumps(layer, indent=2) + "\n")
    return folder


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="OUTPUT_DIR")
    parser.add_argument("--max-zoom", type=int, default=4)
    parser.add_argument("--box", nargs=4, type=float, default=(-180, -90, 180, 90),
                        metavar=("WEST", "SOUTH", "EAST", "NORTH"))
    parser.add_argument("--cells", type=int, default=16, help="per tile edge (default %(default)s)")
    parser.add_argument("--plain", action="store_true", help="do not compress the tiles")
    parser.add_argument("--kind", default="global", help="a surface of make_dem.py")
    write_set(**vars(parser.parse_args()))


if __name__ == "__main__":
    main()
