#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""How many tiles qmeshinfo --validate reads a second on one core.

    python3 autotest/bench/validate_speed.py [--tiles 1024] [--triangles 2000] [--runs 3]

A set of one zoom above the necessary ones is made by gdal2qmesh from a synthetic DEM; its max error is searched for until
tiles have about the triangles asked for. Prints one CSV row: tiles, triangles a tile, bytes a tile, CPU seconds (median
of the runs), tiles a second. CPU time of the whole process, reading and unpacking included.
"""
import argparse
import json
import math
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "autotest" / "tools"))
BIN = pathlib.Path(os.environ.get("QMESH_BIN", ROOT / "build" / "bin" / "gdal2qmesh")).parent


def info(*args):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([BIN / "qmeshinfo", "-q", "--json", *args], stdout=subprocess.PIPE, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return json.loads(run.stdout), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def build(folder, dem, zoom, error):
    subprocess.run([BIN / "gdal2qmesh", "-q", "--overwrite", "-z", f"0-{zoom}", "--max-error", str(error), dem, folder],
                   check=True)
    stats = info("--stats", "-z", str(zoom), folder)[0]["stats"]["levels"][0]
    return stats["triangles"] / stats["tiles"], stats


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tiles", type=int, default=1024)
    parser.add_argument("--triangles", type=int, default=2000)
    parser.add_argument("--runs", type=int, default=3)
    arguments = parser.parse_args()
    from make_dem import make_dem

    zoom, side = 12, max(1, round(math.sqrt(arguments.tiles)))
    size = 180 / 2**zoom
    with tempfile.TemporaryDirectory() as temporary:
        temporary = pathlib.Path(temporary)
        box = (size, 40 * size * 25, size * (1 + side), 40 * size * 25 + size * side)
        pixels = 256 * side
        dem = make_dem("terrain", temporary / "dem.tif", lonlat_box=box, size=(pixels, pixels))
        low, high = 0.01, 1000.0
        for _ in range(7):
            error = math.sqrt(low * high)
            each, stats = build(temporary / "set", dem, zoom, error)
            if abs(each / arguments.triangles - 1) < 0.1:
                break
            low, high = (error, high) if each > arguments.triangles else (low, error)
        seconds = statistics.median(info("--validate", "-j", "1", "-z", str(zoom), temporary / "set")[1]
                                    for _ in range(arguments.runs))
    print("tiles,triangles_per_tile,bytes_per_tile,cpu_seconds,tiles_per_second")
    print(f"{stats['tiles']},{each:.0f},{stats['bytes'] / stats['tiles']:.0f},{seconds:.2f},{stats['tiles'] / seconds:.0f}")


if __name__ == "__main__":
    main()
