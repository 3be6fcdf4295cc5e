#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""How many triangles the point-set methods take by default, beside greedy's.

    point_set_defaults.py --bin build/bin/gdal2qmesh DEM...

Prints a row of a Markdown table for each DEM and method, over all zooms: triangles as a share of
greedy's; and over the three deepest zooms the rms error as a multiple of greedy's and the seconds
one tile of mesh takes on one core.
"""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

METHODS = ["grid", "random", "hierarchy", "wlop"]


def run(binary, dem, options):
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        subprocess.run([binary, "-q", *options, "--processes", "1", "--report", report, dem,
                        pathlib.Path(folder, "out")], check=True)
        return json.loads(report.read_text())


def triangles(report):
    return sum(zoom["triangles"] for zoom in report["zooms"])


def rms(report):
    deep = report["zooms"][-3:]
    tiles = sum(zoom["tiles"] for zoom in deep)
    return math.sqrt(sum(zoom["tiles"] * zoom["rmsError"] ** 2 for zoom in deep) / tiles)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", default="build/bin/gdal2qmesh")
    parser.add_argument("dems", nargs="+", metavar="DEM")
    args = parser.parse_args()
    print("| DEM | method | triangles relative to greedy | rms error relative to greedy | the same without features "
          "| s per tile |")
    print("|---|---|---|---|---|---|")
    for dem in args.dems:
        greedy = run(args.bin, dem, [])
        for method in METHODS:
            made = run(args.bin, dem, ["--method", method])
            bare = run(args.bin, dem, ["--method", method, "--feature-angle", "180"])
            tiles = sum(zoom["tiles"] for zoom in made["zooms"])
            print(f"| {pathlib.Path(dem).stem.split('_')[0]} | {method} "
                  f"| {triangles(made) / triangles(greedy):.2f} | {rms(made) / rms(greedy):.1f} "
                  f"| {rms(bare) / rms(greedy):.1f} | {made['seconds']['mesh'] / tiles:.3f} |",
                  flush=True)


if __name__ == "__main__":
    main()
