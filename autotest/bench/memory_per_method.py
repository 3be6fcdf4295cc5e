#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Memory a method takes for each node of a tile, as a table in Markdown.

    memory_per_method.py [--cells 512] [--only METHOD] [--border inherit] [--bin build/bin/gdal2qmesh]

One tile of so many cells and the same terrain as tiles of a quarter of them, with one thread and nothing else
different: the difference of the peaks, less that of the windows of nodes (5 bytes a node), by the difference of
the nodes of a tile. What the program, the reader and the caches take falls out. The worst of a method's rows,
plus a tenth, is SimplifierInfo::bytesPerNode (common/simplify/registry.cpp).

Terrains: rough hills, and blades: every other column of nodes 300 m higher, so that all columns are features, as
many as there can be of the default least length.
"""

import argparse
import os
import pathlib
import sys
import tempfile

import numpy as np
from osgeo import gdal

ROOT = pathlib.Path(__file__).resolve().parents[2]
for folder in ("utils", "tools"):
    sys.path.insert(0, str(ROOT / "autotest" / folder))

from make_dem import make_dem, spatial_reference  # noqa: E402
from measure import measured  # noqa: E402

WINDOW_BYTES = 5  # of a node: its height and a mark

ALL_FEATURES = ["--border-max-error", "0"]
SHORT_FEATURES = ["--feature-angle", "0", "--feature-min-size", "1"]

# Defaults and the settings that leave the most: what a user may ask for.
RUNS = [
    ("hills", "greedy", []),
    ("hills", "greedy", ["--max-error", "0"]),
    ("hills", "collapse", []),
    ("hills", "collapse", ["--max-error", "0"]),
    ("hills", "collapse", ["--edge-ratio", "0.3"]),
    ("hills", "collapse", ["--edge-ratio", "0.3", "--cost", "garland-heckbert"]),
    ("hills", "grid", []),
    ("hills", "grid", ["--cell-size", "0.001"]),
    ("blades", "grid", ["--cell-size", "0.001", *ALL_FEATURES]),
    ("hills", "random", []),
    ("hills", "random", ["--random-percent", "0"]),
    ("blades", "random", ["--random-percent", "0", *ALL_FEATURES]),
    ("hills", "random", SHORT_FEATURES),
    ("hills", "hierarchy", []),
    ("hills", "hierarchy", ["--cluster-size", "1"]),
    ("blades", "hierarchy", ["--cluster-size", "1", *ALL_FEATURES]),
    ("hills", "wlop", []),
    ("hills", "wlop", ["--retain-percent", "100"]),
    ("blades", "wlop", ["--retain-percent", "100", *ALL_FEATURES]),
    ("hills", "qem", []),
    ("hills", "qem", ["--svo", "0"]),
    ("hills", "quadtree", []),
    ("hills", "quadtree", ["--max-error", "0"]),
    ("hills", "quadtree", ["--curvature", "0"]),
    ("hills", "delaunay", []),
]


class Tile:
    """The large tile, in the Alps, whose nodes are as far apart at any number of cells."""

    def __init__(self, cells):
        self.cells = cells
        self.zoom = 19 - cells.bit_length() + 1
        self.size = 180 / 2**self.zoom
        self.west = self.size * int(189.84375 / self.size) - 180
        self.south = self.size * int(136.0546875 / self.size) - 90

    def hills(self, path):
        inside = self.size / 100  # so that no other tile is touched
        box = (self.west + inside, self.south + inside, self.west + self.size - inside, self.south + self.size - inside)
        return make_dem("terrain", path, size=(self.cells, self.cells), lonlat_box=box)

    def blades(self, path):
        """Pixels with their centres at the nodes."""
        step, nodes = self.size / self.cells, self.cells + 1
        data = gdal.GetDriverByName("GTiff").Create(str(path), nodes, nodes, 1, gdal.GDT_Float32)
        data.SetGeoTransform((self.west - step / 2, step, 0, self.south + self.size + step / 2, 0, -step))
        data.SetProjection(spatial_reference("EPSG:4326").ExportToWkt())
        row, column = np.mgrid[0:nodes, 0:nodes]
        data.GetRasterBand(1).WriteArray((column % 2 * 300 + row * 0.01).astype(np.float32))
        return path


def peak(program, dem, cells, zoom, options):
    """Bytes at the peak of a run with tiles of a size."""
    with tempfile.TemporaryDirectory(prefix="qmesh-memory-") as folder:
        run = measured([program, "-q", "-j", "1", "--memory", "8GB", "--block-tiles", "2", "--tilesize", cells,
                        "-z", f"{zoom}-{zoom}", *options, dem, f"{folder}/out"], seconds=1200)
    if run["code"] != 0:
        sys.exit(f"{' '.join(options)}: exit code {run['code']}\n{run['err']}")
    return run["peak_bytes"]


def bytes_per_node(program, dem, tile, options):
    small = tile.cells // 4
    difference = (peak(program, dem, tile.cells, tile.zoom, options)
                  - peak(program, dem, small, tile.zoom + 2, options))
    windows = WINDOW_BYTES * (tile.cells**2 - (2 * small)**2)  # one large tile, a block of 2 x 2 small ones
    return (difference - windows) / ((tile.cells + 1)**2 - (small + 1)**2)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=512, choices=[256, 512, 1024])
    parser.add_argument("--only", action="append", help="a method; may be given again")
    parser.add_argument("--border", default="shared", choices=["shared", "inherit"])
    parser.add_argument("--bin", type=pathlib.Path,
                        default=os.environ.get("QMESH_BIN", ROOT / "build" / "bin" / "gdal2qmesh"))
    args = parser.parse_args()
    tile = Tile(args.cells)
    with tempfile.TemporaryDirectory(prefix="qmesh-memory-dem-") as folder:
        dems = {name: getattr(tile, name)(pathlib.Path(folder) / f"{name}.tif") for name in ("hills", "blades")}
        print("| method | terrain | options | bytes per node |\n|---|---|---|---:|")
        for terrain, method, options in RUNS:
            if args.only and method not in args.only:
                continue
            whole = ["--method", method, "--border", args.border, *options]
            print(f"| {method} | {terrain} | {' '.join(options) or 'defaults'} | "
                  f"{bytes_per_node(args.bin, dems[terrain], tile, whole):.0f} |", flush=True)


if __name__ == "__main__":
    main()
